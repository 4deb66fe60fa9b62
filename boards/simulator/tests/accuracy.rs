//! The command `accuracy`, as it is called.

use std::{collections::HashMap, env, fs, path::PathBuf, process::Command};

/// Runs it quickly into a folder of its own; returns that.
fn run(axis: &str) -> PathBuf {
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(format!("accuracy-{axis}"));
    let _ = fs::remove_dir_all(&folder);
    let output = Command::new(env!("CARGO_BIN_EXE_zrow-simulator"))
        .args(["accuracy", "--quick", "--only", axis, "--output"])
        .arg(&folder)
        .output()
        .unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    folder
}

#[test]
fn coverage_has_its_columns_and_the_known_ranking() {
    let folder = run("coverage");
    let mut reader = csv::Reader::from_path(folder.join("coverage.csv")).unwrap();
    let columns = [
        "class",
        "method",
        "rms255",
        "max255",
        "bytes_per_row",
        "ns",
        "instructions",
    ];
    assert_eq!(reader.headers().unwrap(), &csv::StringRecord::from(columns.to_vec()));
    let rows = reader.records().map(|row| {
        let row = row.unwrap();
        ((row[0].to_owned(), row[1].to_owned()), row[2].parse::<f64>().unwrap())
    });
    let rms: HashMap<_, _> = rows.collect();
    let of = |class: &str, method: &str| rms[&(class.to_owned(), method.to_owned())];
    // Published and measured elsewhere: about 69, 24, 11.7 and below 0.7 on simple shapes.
    assert!((60.0..80.0).contains(&of("triangle", "centre_sample")));
    assert!((20.0..28.0).contains(&of("triangle", "rooks_4")));
    assert!((8.0..14.0).contains(&of("triangle", "grid_4")));
    assert!(of("triangle", "signed_area") < 0.7);
    // Crossing edges inside a pixel.
    assert!(of("star", "inside_area") < of("star", "signed_area") / 2.0);
}

#[test]
fn the_page_needs_nothing_beside_it() {
    let folder = run("clipping");
    let page = fs::read_to_string(folder.join("index.html")).unwrap();
    assert!(page.contains("<svg") && page.contains("data:image/png;base64,") && page.contains("coarse"));
    assert!(!page.contains("<link") && !page.contains("<script") && !page.contains("src=\"http"));
    assert!(folder.join("clipping-lines_of_7_000_px-ns.png").is_file());
}
