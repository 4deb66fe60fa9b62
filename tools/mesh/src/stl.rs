//! Reads the triangles of an STL file, of text or binary. Its normals are not read: the order of the corners says the same.

use anyhow::{Context, bail, ensure};

use crate::{
    lines::{keyword, number, numbers, shown, statements, text},
    model::{Corner, Face, Model},
};

/// Bytes before the first facet of a binary file: a title, and the number of facets.
const HEAD: usize = 84;
/// Bytes of a binary facet: normal, three corners, an attribute.
const FACET: usize = 50;

/// Reads an STL file.
///
/// # Errors
/// Each bad line, by its number, or each bad facet of a binary file.
pub fn parse(bytes: &[u8], file: &str) -> anyhow::Result<Model> {
    let mut model = Model {
        file: file.to_owned(),
        ..Model::default()
    };
    // Some binary files begin with "solid", too: their length tells them apart.
    let facets = bytes
        .get(HEAD - 4..)
        .and_then(|rest| rest.first_chunk())
        .map(|&count| u32::from_le_bytes(count));
    let has_length = facets.is_some_and(|facets| binary_length(facets) == bytes.len() as u64);
    if has_length {
        model.is_binary = true;
        read_binary(bytes.get(HEAD..).unwrap_or_default(), &mut model)?;
    } else if is_text(bytes) {
        read_text(&text(bytes), &mut model)?;
    } else {
        let facets = facets.with_context(|| format!("{file} is no STL: it has {} bytes", bytes.len()))?;
        bail!(
            "{file} has {} bytes, and {} as a binary STL of {facets} facets: copy or export it again",
            bytes.len(),
            binary_length(facets)
        );
    }
    Ok(model)
}

/// Whether a file begins with the first word of a text, in small letters or capitals, perhaps behind a byte order mark.
fn is_text(bytes: &[u8]) -> bool {
    let bytes = bytes.strip_prefix("\u{feff}".as_bytes()).unwrap_or(bytes);
    let word = bytes.trim_ascii_start().get(..5);
    word.is_some_and(|word| word.eq_ignore_ascii_case(b"solid"))
}

fn binary_length(facets: u32) -> u64 {
    HEAD as u64 + FACET as u64 * u64::from(facets)
}

fn read_binary(bytes: &[u8], model: &mut Model) -> anyhow::Result<()> {
    for (facet, bytes) in (1..).zip(bytes.chunks_exact(FACET)) {
        let numbers: Vec<f32> = bytes
            .chunks_exact(4)
            .filter_map(|number| number.first_chunk().copied().map(f32::from_le_bytes))
            .collect();
        // The normal stands before the corners.
        for corner in numbers.chunks_exact(3).skip(1) {
            // Through text, as a text file has it: the shortest number that is that of 32 bits.
            let read = |index: usize| number(&corner[index].to_string());
            let corner = read(0)
                .and_then(|x| Ok([x, read(1)?, read(2)?]))
                .with_context(|| format!("{} facet {facet}", model.file))?;
            model.positions.push(corner);
        }
        add_facet(model, facet);
    }
    Ok(())
}

/// Where in a facet a text is.
#[derive(Copy, Clone, PartialEq, Eq)]
enum State {
    Outside,
    Solid,
    Facet,
    Loop { corners: usize },
    LoopEnded,
}

fn read_text(text: &str, model: &mut Model) -> anyhow::Result<()> {
    let (mut state, mut facet) = (State::Outside, 0);
    let mut last = 0;
    for (line, statement) in statements(text) {
        let place = format!("{} line {line}", model.file);
        if keyword(&statement).0.eq_ignore_ascii_case("facet") {
            facet = line;
        }
        state = next_state(state, &statement, model).context(place)?;
        if state == State::LoopEnded && keyword(&statement).0.eq_ignore_ascii_case("endloop") {
            add_facet(model, facet);
        }
        last = line;
    }
    ensure!(
        state == State::Outside,
        "{} line {last}: the file ends within a solid: copy or export it again",
        model.file
    );
    Ok(())
}

fn next_state(state: State, statement: &str, model: &mut Model) -> anyhow::Result<State> {
    let (word, rest) = keyword(statement);
    Ok(match (state, word.to_ascii_lowercase().as_str()) {
        (State::Outside, "solid") => State::Solid,
        (State::Solid, "facet") => State::Facet,
        (State::Solid, "endsolid") => State::Outside,
        (State::Facet, "outer") => State::Loop { corners: 0 },
        (
            State::Loop {
                corners: corners @ 0..3,
            },
            "vertex",
        ) => {
            let values = numbers(rest, &[3], "vertex x y z")?;
            model.positions.push([values[0], values[1], values[2]]);
            State::Loop { corners: corners + 1 }
        }
        (State::Loop { corners: 3 }, "endloop") => State::LoopEnded,
        (State::LoopEnded, "endfacet") => State::Solid,
        _ => {
            let expected = match state {
                State::Outside => "solid",
                State::Solid => "facet or endsolid",
                State::Facet => "outer loop",
                State::Loop { corners: 3 } => "endloop",
                State::Loop { .. } => "vertex x y z",
                State::LoopEnded => "endfacet",
            };
            bail!(
                "{} stands where {expected} has to stand: export the model again",
                shown(word)
            )
        }
    })
}

/// A face of the last three positions.
fn add_facet(model: &mut Model, line: usize) {
    let (first, end) = (model.corners.len(), model.positions.len());
    model
        .corners
        .extend((end.saturating_sub(3)..end).map(|position| Corner {
            position,
            coordinates: None,
            normal: None,
        }));
    model.faces.push(Face {
        corners: first..model.corners.len(),
        material: None,
        line,
    });
}
