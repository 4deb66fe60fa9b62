//! What an axis of the report is: a family of methods, how wrong each is, and what it costs.

use super::{
    counted::{Chip, Counted},
    picture::Picture,
    timing::Plan,
};

/// A question of accuracy against cost. Each has a file of its own and an entry in the list of all of them.
pub trait Axis {
    /// Its name in file names.
    fn name(&self) -> &'static str;

    /// The counts of `measure` that it wants; none where it shows recorded ones.
    fn counts(&self) -> Vec<String>;

    /// Runs it.
    ///
    /// # Errors
    /// A method refused its input.
    fn run(&self, context: &Context<'_>) -> anyhow::Result<Chapter>;
}

/// What every axis gets.
pub struct Context<'a> {
    /// How much is run.
    pub plan: &'a Plan,
    /// What the emulated chip counted.
    pub counted: &'a Counted,
    /// Called with what is going on.
    pub progress: &'a dyn Fn(&str),
}

/// What an axis found.
pub struct Chapter {
    pub name: &'static str,
    pub title: &'static str,
    /// What is run, on what, and how errors are defined; a paragraph each.
    pub about: Vec<String>,
    /// What a cost is the cost of.
    pub operation: &'static str,
    /// What the memory of an entry is; nothing where none of the methods needs any.
    pub memory: Option<&'static str>,
    /// Names of the figures of each entry; the first one is the charts' error.
    pub figures: Vec<&'static str>,
    /// Drawings before everything else.
    pub diagrams: Vec<Diagram>,
    /// What is said before the groups, one method beside the other.
    pub summaries: Vec<Summary>,
    pub entries: Vec<Entry>,
}

/// A drawing that was made elsewhere.
pub struct Diagram {
    /// In file names, with the chapter's name before it.
    pub name: String,
    pub title: String,
    /// The text of an SVG file.
    pub svg: String,
}

/// A table over all groups.
pub struct Summary {
    pub title: String,
    pub columns: Vec<String>,
    pub rows: Vec<Vec<Cell>>,
}

/// A cell of it.
pub struct Cell {
    pub text: String,
    /// Whether it is to be seen first.
    pub is_strong: bool,
}

impl From<String> for Cell {
    /// One like all others.
    fn from(text: String) -> Self {
        Self { text, is_strong: false }
    }
}

/// One method on one group of inputs.
pub struct Entry {
    pub group: String,
    pub method: String,
    /// As many as the chapter names.
    pub figures: Vec<f64>,
    pub memory_bytes: usize,
    /// On this host; nothing where it was not timed.
    pub time: Option<super::timing::Spread>,
    /// On the emulated chips.
    pub chip: Chip,
    pub picture: Option<Picture>,
}

impl Entry {
    /// What the charts show as its error.
    pub fn error(&self) -> f64 {
        self.figures.first().copied().unwrap_or_default()
    }
}

impl Chapter {
    /// The groups in the order of their first entries.
    pub fn groups(&self) -> Vec<&str> {
        let mut groups: Vec<&str> = Vec::new();
        for entry in &self.entries {
            if !groups.contains(&entry.group.as_str()) {
                groups.push(&entry.group);
            }
        }
        groups
    }

    /// The entries of a group.
    pub fn of_group(&self, group: &str) -> Vec<&Entry> {
        self.entries.iter().filter(|entry| entry.group == group).collect()
    }

    /// The name of a group in the report's links and file names, with the chapter's name before it.
    pub fn group_name(&self, group: &str) -> String {
        let letter = |letter: char| if letter.is_ascii_alphanumeric() { letter } else { '_' };
        let group: String = group.chars().map(letter).collect();
        format!("{}-{group}", self.name)
    }
}
