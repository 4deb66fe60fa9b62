//! Pictures beside the shapes: how many patterns a file's tests compare.

use std::fs;

use syn::{ExprMethodCall, visit::Visit};

use crate::source::source_folder;

/// The folders with a file for each shape.
const FOLDERS: [&str; 3] = ["draw/eg", "draw/shapes", "draw/antialiased"];

/// The files in these folders that hold no shape, but what several shapes or styles need.
const WITHOUT_SHAPE: [&str; 22] = [
    "draw/eg/areas.rs",
    "draw/eg/font_glyphs.rs",
    "draw/eg/glyph_bits.rs",
    "draw/eg/image_bytes.rs",
    "draw/eg/mod.rs",
    "draw/eg/styled_areas.rs",
    "draw/eg/styled_pixels.rs",
    "draw/eg/text_lines.rs",
    "draw/shapes/flat_steps.rs",
    "draw/shapes/mod.rs",
    "draw/shapes/path_command.rs",
    "draw/antialiased/antialiased_target.rs",
    "draw/antialiased/arc_turns.rs",
    "draw/antialiased/coverage_choice.rs",
    "draw/antialiased/edges_in_rows.rs",
    "draw/antialiased/layers.rs",
    "draw/antialiased/mod.rs",
    "draw/antialiased/multisampled.rs",
    "draw/antialiased/outline_arc.rs",
    "draw/antialiased/round_outline.rs",
    "draw/antialiased/sub_outline.rs",
    "draw/antialiased/turn.rs",
];

/// How many pictures a shape has beside its code, at least.
const LEAST: usize = 3;

/// Every file of a shape, its name from `src/` on and its text.
pub fn shapes() -> Vec<(String, String)> {
    let mut shapes = Vec::new();
    for folder in FOLDERS {
        for entry in fs::read_dir(source_folder().join(folder)).unwrap() {
            let entry = entry.unwrap();
            let name = format!("{folder}/{}", entry.file_name().to_str().unwrap());
            if !WITHOUT_SHAPE.contains(&name.as_str()) {
                shapes.push((name, fs::read_to_string(entry.path()).unwrap()));
            }
        }
    }
    shapes.sort();
    shapes
}

/// The names of the files that have too few pictures, each with how many it has.
pub fn without_pictures(shapes: &[(String, String)]) -> Vec<String> {
    let counted = shapes.iter().map(|(name, source)| (name, patterns(source)));
    counted
        .filter(|&(_, count)| count < LEAST)
        .map(|(name, count)| format!("{name}: {count}"))
        .collect()
}

/// How often a file calls `assert_pattern`; the examples in its documentation do not count.
fn patterns(source: &str) -> usize {
    let mut calls = PatternCalls::default();
    calls.visit_file(&syn::parse_file(source).unwrap());
    calls.0
}

#[derive(Default)]
struct PatternCalls(usize);

impl<'ast> Visit<'ast> for PatternCalls {
    fn visit_expr_method_call(&mut self, call: &'ast ExprMethodCall) {
        if call.method == "assert_pattern" {
            self.0 += 1;
        }
        syn::visit::visit_expr_method_call(self, call);
    }
}
