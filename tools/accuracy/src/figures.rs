//! From entries to charts.

use super::{
    axis::{Chapter, Entry},
    chart::{Chart, Mark},
    names,
};

/// What is on the axis of costs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Cost {
    /// Nanoseconds on this host.
    Time,
    /// Instructions on the emulated chip.
    Instructions,
    /// Estimated cycles of them.
    Cycles,
    /// Bytes of a program.
    Flash,
}

impl Cost {
    /// That of an entry, if it was measured.
    pub fn of(self, entry: &Entry) -> Option<f64> {
        match self {
            Self::Time => entry.time.map(|time| time.median),
            Self::Instructions => entry.chip.instructions,
            Self::Cycles => entry.chip.cycles,
            Self::Flash => entry.chip.flash_bytes,
        }
    }

    /// In file names.
    pub fn name(self) -> &'static str {
        match self {
            Self::Time => "ns",
            Self::Instructions => "instructions",
            Self::Cycles => "cycles",
            Self::Flash => "flash",
        }
    }

    fn label(self, operation: &str) -> String {
        match self {
            Self::Time => format!("nanoseconds for {operation} on this host"),
            Self::Instructions => format!("instructions for {operation} on an emulated Cortex-M4"),
            Self::Cycles => format!("estimated cycles for {operation} on a Cortex-M4"),
            Self::Flash => "bytes of flash".to_owned(),
        }
    }
}

/// The charts of a group, one for each cost that entries have: of flash, more than one, because it says little by itself.
pub fn charts(chapter: &Chapter, group: &str) -> Vec<(Cost, Chart)> {
    let entries = chapter.of_group(group);
    let charts = [Cost::Time, Cost::Instructions, Cost::Cycles, Cost::Flash].map(|cost| {
        let marks: Vec<_> = entries.iter().filter_map(|entry| mark(entry, cost)).collect();
        let chart = Chart {
            title: format!("{}, {}", chapter.name.replace('_', "-"), group.replace('_', " ")),
            memory: chapter.memory,
            cost: cost.label(chapter.operation),
            error: chapter.figures.first().copied().unwrap_or_default().to_owned(),
            marks,
        };
        (cost, chart)
    });
    charts
        .into_iter()
        .filter(|(cost, chart)| chart.marks.len() > usize::from(*cost == Cost::Flash))
        .collect()
}

fn mark(entry: &Entry, cost: Cost) -> Option<Mark> {
    Some(Mark {
        name: label(&entry.method),
        error: entry.error(),
        cost: cost.of(entry).filter(|cost| *cost > 0.0)?,
        spread: entry
            .time
            .filter(|_| cost == Cost::Time)
            .map(|time| (time.low, time.high)),
        memory_bytes: entry.memory_bytes,
    })
}

/// The name for people; a long name of an algorithm by its first word, so that labels keep clear of each other.
fn label(method: &str) -> String {
    let (name, rest) = method.split_once(' ').unwrap_or((method, ""));
    let first = name.split('_').next().unwrap_or(name);
    if method.len() > 20 && first != name && !rest.is_empty() {
        names::title(&format!("{first} {rest}"))
    } else {
        names::title(method)
    }
}

#[cfg(test)]
mod tests {
    use super::label;

    #[test]
    fn only_long_names_are_cut() {
        let methods = [
            "adaptive_forward_difference 1/8",
            "de_casteljau 1/8",
            "1/65536 px, grown window",
        ];
        assert_eq!(
            methods.map(label),
            ["adaptive 1/8", "de Casteljau 1/8", "1/65536 px, grown window"]
        );
    }
}
