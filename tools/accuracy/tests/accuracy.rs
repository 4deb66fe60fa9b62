//! The command `accuracy`, as it is called.

use std::{collections::HashMap, env, fs, path::PathBuf, process::Command};

/// Runs it quickly into a folder of its own; returns that.
fn run(axis: &str) -> PathBuf {
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(format!("accuracy-{axis}"));
    let _ = fs::remove_dir_all(&folder);
    let output = Command::new(env!("CARGO_BIN_EXE_zrow-accuracy"))
        .args(["--quick", "--only", axis, "--output"])
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
    let rows: Vec<_> = reader.records().map(Result::unwrap).collect();
    let classes: Vec<&str> = rows.iter().map(|row| &row[0]).collect();
    let classes: Vec<&str> = classes.chunk_by(|a, b| a == b).map(|chunk| chunk[0]).collect();
    let expected = [
        "all",
        "triangle",
        "line",
        "near_horizontal",
        "near_vertical",
        "hairline",
        "circle",
        "ring",
        "star",
    ];
    assert_eq!(classes, expected);
    let rows = rows.iter().map(|row| {
        let (bytes, ns): (usize, f64) = (row[4].parse().unwrap(), row[5].parse().unwrap());
        assert!(ns > 0.0 && bytes < 1000, "{row:?}");
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
    // The spread of times, and the commands.
    assert!(page.contains("middle half of 11 rounds"));
    assert!(page.contains("cargo run --release -- accuracy --only clipping"));
    assert!(folder.join("clipping-lines_of_7_000_px-ns.png").is_file());
}

#[test]
fn a_quick_run_leaves_other_rasterizers_out_and_says_so() {
    let folder = run("rasterizers");
    let page = fs::read_to_string(folder.join("index.html")).unwrap();
    assert!(page.contains("They were not run: a quick run does not build them."));
    assert_eq!(
        fs::read_to_string(folder.join("rasterizers.csv"))
            .unwrap()
            .lines()
            .count(),
        1
    );
}

#[test]
fn every_other_axis_times_every_method() {
    for axis in ["sub_pixel", "lines", "circles", "curves"] {
        let folder = run(axis);
        let mut reader = csv::Reader::from_path(folder.join(format!("{axis}.csv"))).unwrap();
        let ns = reader.headers().unwrap().iter().position(|name| name == "ns").unwrap();
        let rows: Vec<_> = reader.records().map(Result::unwrap).collect();
        assert!(rows.len() > 3, "{axis}");
        for row in rows {
            assert!(row[ns].parse::<f64>().unwrap() > 0.0, "{axis}: {row:?}");
        }
    }
}
