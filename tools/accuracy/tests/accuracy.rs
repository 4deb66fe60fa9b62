//! The command `accuracy`, as it is called.

use std::{
    collections::HashMap,
    env, fs,
    path::PathBuf,
    process::Command,
    sync::atomic::{AtomicUsize, Ordering},
};

/// Runs it quickly into a folder of its own; returns that.
fn run(axis: &str) -> PathBuf {
    // Tests run at once.
    static RUNS: AtomicUsize = AtomicUsize::new(0);
    let run = RUNS.fetch_add(1, Ordering::Relaxed);
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(format!("accuracy-{axis}-{run}"));
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

/// The answer comes first: a sentence, a chart, the star four times; machine and warnings come last.
#[test]
fn the_first_screen_says_what_accuracy_costs() {
    let page = fs::read_to_string(run("coverage").join("index.html")).unwrap();
    let place = |part: &str| page.find(part).unwrap_or_else(|| panic!("{part} is missing"));
    assert!(page.contains("estimated cycles of a Cortex-M4 without antialiasing"));
    let parts = [
        "<p class=\"answer\">A shape takes ",
        "<div class=\"diagram\"><svg",
        "<b>no antialiasing</b>",
        "<b>16 samples, n-rooks</b>",
        "<b>exact area</b>",
        "<b>exact area, crossings too</b>",
        "<h2 id=\"contents\">",
        "<h2 id=\"coverage\">",
        "<h2 id=\"run\">",
        "were not counted in this run, but on 20",
        ">machine</td>",
    ];
    assert!(parts.map(place).is_sorted(), "{:?}", parts.map(place));
    assert!(!page.contains("rooks_16"), "a name of code");
}

#[test]
fn hard_cases_are_a_table() {
    let folder = run("hard_cases");
    let page = fs::read_to_string(folder.join("index.html")).unwrap();
    assert!(page.contains("a bow tie") && page.contains("vello #380"));
    let csv = fs::read_to_string(folder.join("hard_cases.csv")).unwrap();
    assert!(csv.lines().count() > 50, "{csv}");
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
fn visibility_is_what_was_recorded() {
    let folder = run("visibility");
    let page = fs::read_to_string(folder.join("index.html")).unwrap();
    assert!(page.contains("Measured on 20") && page.contains("measures none of them"));
    assert_eq!(page.matches("<div class=\"diagram\"><svg").count(), 4);
    for name in ["m4-cycles", "m4-instructions", "m0plus-cycles", "m0plus-instructions"] {
        let svg = fs::read_to_string(folder.join(format!("visibility-{name}.svg"))).unwrap();
        assert!(page.contains(&svg), "{name}");
    }
    let csv = fs::read_to_string(folder.join("visibility.csv")).unwrap();
    let docs = fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/../../docs/visibility.md")).unwrap();
    // Each cell of each table: its title, its line, its column and its figure.
    let mut reader = csv::Reader::from_reader(csv.as_bytes());
    let rows: Vec<_> = reader.records().map(Result::unwrap).collect();
    assert_eq!(rows.len(), 9 * (2 * (6 + 5 + 5) + 7));
    assert!(rows.iter().all(|row| docs.contains(&format!(" {} |", &row[3]))));
    let is_row = |row: &csv::StringRecord| &row[1] == "depth row" && &row[2] == "4,992" && row[0].contains("M4");
    let of_row = rows.iter().find(|row| is_row(row)).unwrap();
    assert!(docs.contains(&format!("| {} |\n| intervals", &of_row[3])));
}

#[test]
fn every_other_axis_times_every_method() {
    for axis in [
        "sub_pixel",
        "lines",
        "circles",
        "curves",
        "depth_width",
        "positions",
        "matrix_format",
        "perspective",
        "trigonometry",
    ] {
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

/// The figures of a table by group and method.
fn figures(axis: &str, column: usize) -> HashMap<(String, String), f64> {
    let mut reader = csv::Reader::from_path(run(axis).join(format!("{axis}.csv"))).unwrap();
    let rows = reader.records().map(Result::unwrap);
    rows.map(|row| {
        let figure = row[2 + column].parse().unwrap();
        ((row[0].to_owned(), row[1].to_owned()), figure)
    })
    .collect()
}

fn of(figures: &HashMap<(String, String), f64>, group: &str, method: &str) -> f64 {
    figures[&(group.to_owned(), method.to_owned())]
}

/// A depth of 16 bits is z * z / (65,535 near) of space; corners at 1/16 px are within half of that in both directions, so
/// sqrt(2) * 8 / 256 px, and a matrix in 2.14 adds what half of 2^-14 makes of 20,000 units.
#[test]
fn formats_in_space_have_the_errors_that_follow_from_their_bits() {
    let misordered = figures("depth_width", 0);
    let close = |method| of(&misordered, "faces 2 to 16 units apart", method);
    assert!(close("u16, near 8") > 5.0);
    assert!(close("u16, near 128") < 0.05 && close("u32, near 8") < 0.01);

    let corners = figures("positions", 1);
    assert!((8.0..13.0).contains(&of(&corners, "at 300 units", "1/16 px")));
    assert!((0.4..0.8).contains(&of(&corners, "at 300 units", "1/256 px")));

    let far = figures("matrix_format", 0);
    let (group, finest) = ("20,000 from the origin, at 150", "2.30, 1/256 px");
    // Up to 1.06 units of space, 96 / 120 px a unit: at most 0.85 px, and seldom all of that.
    assert!((80.0..230.0).contains(&of(&far, group, "2.14, 1/16 px")));
    assert!(of(&far, group, "8.24, 1/16 px") < 13.0 && of(&far, group, finest) < 1.0);
}

#[test]
fn texels_are_exact_where_they_are_divided() {
    let texels = figures("perspective", 0);
    let error = |method| of(&texels, "depths 1 to 2", method);
    assert!(error("affine") > 5.0 && (0.2..4.0).contains(&error("every 16 px")));
    // The error of a line grows with the square of its length.
    assert!((0.15..0.4).contains(&(error("every 8 px") / error("every 16 px"))));
    assert!(error("every px") < 0.03 && error("every fragment") < 0.03);
}

#[test]
fn sines_have_the_errors_of_their_numbers() {
    let millionths = figures("trigonometry", 0);
    let error = |method| of(&millionths, "all angles", method);
    // 2^-27; a step of 1/512 turn; micromath's own documentation has 0.2 %.
    assert!(error("zrow's polynomial") < 0.0075 && error("table of 129") > 6_000.0);
    assert!((500.0..2_000.0).contains(&error("micromath, f32")));
}
