//! Files of the repository that are written from figures, and the tables in them.

use std::{
    fs,
    path::{Path, PathBuf},
};

use anyhow::Context;

use crate::case::Figure;

/// The figure of a name on one target.
///
/// # Errors
///
/// It was not measured.
pub fn figure<'f>(figures: &'f [Figure], name: &str, target: &str) -> anyhow::Result<&'f Figure> {
    let mut figures = figures.iter();
    let figure = figures.find(|figure| figure.case.name == name && figure.case.target == target);
    figure.with_context(|| format!("{name} was not measured: leave out --only and --target"))
}

/// A file of the repository.
fn path(file: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").join(file)
}

/// The text of a file of the repository.
///
/// # Errors
///
/// It cannot be read.
pub fn read(file: &str) -> anyhow::Result<String> {
    fs::read_to_string(path(file)).with_context(|| format!("cannot read {file}"))
}

/// Writes a file of the repository anew.
///
/// # Errors
///
/// It cannot be written.
pub fn write(file: &str, text: &str) -> anyhow::Result<()> {
    fs::write(path(file), text).with_context(|| format!("cannot write {file}"))
}

/// A page up to a table, the table, and what follows it.
///
/// # Errors
///
/// The page has no such table, or the table has no end.
pub fn parts<'p>(page: &'p str, name: &str) -> anyhow::Result<(&'p str, &'p str, &'p str)> {
    let begin = format!("<!-- {name} -->\n\n");
    let start = page.find(&begin).map(|start| start + begin.len());
    let start = start.with_context(|| format!("the page has no `{}`", begin.trim_end()))?;
    let length = page[start..].find("\n<!-- end -->");
    let length = length.with_context(|| format!("the table `{name}` has no end"))?;
    let (before, rest) = page.split_at(start);
    let (table, after) = rest.split_at(length);
    Ok((before, table, after))
}
