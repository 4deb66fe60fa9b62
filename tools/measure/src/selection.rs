//! The cases that a user asks for, and what is said where there is none.

use std::{collections::BTreeSet, error::Error, fmt};

use crate::case::Case;

/// How many texts are proposed instead of one that no name has.
const PROPOSALS: usize = 6;
/// How alike a proposal is to what was asked for at least: 1 is the same.
const LEAST_SIMILARITY: f64 = 0.75;

/// No case has such a name on such a target; says what to ask for instead.
#[derive(Debug, PartialEq, Eq)]
pub struct NothingSelected(String);

impl fmt::Display for NothingSelected {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(&self.0)
    }
}

impl Error for NothingSelected {}

/// The cases with a text in their names, on targets with a text in theirs.
///
/// # Errors
///
/// [`NothingSelected`] where no case is left.
pub fn select(cases: Vec<Case>, only: Option<&str>, target: Option<&str>) -> Result<Vec<Case>, NothingSelected> {
    let has_name = |case: &Case| case.name.contains(only.unwrap_or_default());
    let is_on = |case: &Case| case.target.contains(target.unwrap_or_default());
    let (selected, others): (Vec<_>, Vec<_>) = cases.into_iter().partition(|case| has_name(case) && is_on(case));
    if !selected.is_empty() {
        return Ok(selected);
    }
    let is_measured_elsewhere = others.iter().any(has_name);
    Err(NothingSelected(if is_measured_elsewhere {
        of_targets(&others, has_name, only, target.unwrap_or_default())
    } else {
        of_names(&others, only.unwrap_or_default())
    }))
}

/// What is said where a name is not measured on a target.
fn of_targets(cases: &[Case], has_name: impl Fn(&Case) -> bool, only: Option<&str>, target: &str) -> String {
    let with_name = only
        .map(|only| format!(" with `{only}` in its name"))
        .unwrap_or_default();
    let targets = cases.iter().filter(|case| has_name(case)).map(|case| case.target);
    let targets: BTreeSet<_> = targets.collect();
    format!(
        "nothing{with_name} is measured on a target with `{target}` in its name\n\n  take --target with one of: {}",
        listed(targets)
    )
}

/// What is said where no name has a text in it.
fn of_names(cases: &[Case], only: &str) -> String {
    let nearest = nearest(cases, only);
    let proposals = if nearest.is_empty() {
        format!("take --only with one of: {}", listed(families(cases)))
    } else {
        format!("the nearest that there are: {}", listed(nearest))
    };
    format!(
        "nothing that is measured has `{only}` in its name\n\n  {proposals}\n  or leave --only out, which measures all of it"
    )
}

/// The texts before the first dot of the names.
fn families(cases: &[Case]) -> BTreeSet<&str> {
    cases.iter().map(|case| prefixes(&case.name)[0]).collect()
}

/// The texts most like the one that was asked for: names, parts of them between dots, and what comes before a dot.
fn nearest<'c>(cases: &'c [Case], only: &str) -> Vec<&'c str> {
    let names = cases.iter().map(|case| case.name.as_str());
    let texts: BTreeSet<_> = names
        .flat_map(|name| prefixes(name).into_iter().chain(name.split('.')))
        .collect();
    let mut texts: Vec<_> = texts
        .into_iter()
        .map(|text| (strsim::jaro_winkler(text, only), text))
        .filter(|(similarity, _)| *similarity >= LEAST_SIMILARITY)
        .collect();
    // The sort keeps the order of the alphabet where two are as near.
    texts.sort_by(|(one, _), (other, _)| other.total_cmp(one));
    let mut proposals: Vec<&str> = Vec::new();
    for (_, text) in texts {
        // What has a proposal in it is selected by that one.
        if proposals.len() < PROPOSALS && !proposals.iter().any(|proposal| text.contains(proposal)) {
            proposals.push(text);
        }
    }
    proposals
}

/// A name up to each of its dots, and all of it.
fn prefixes(name: &str) -> Vec<&str> {
    let dots = name.match_indices('.').map(|(dot, _)| dot);
    dots.chain([name.len()]).filter_map(|end| name.get(..end)).collect()
}

fn listed<'c>(texts: impl IntoIterator<Item = &'c str>) -> String {
    Vec::from_iter(texts).join(", ")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cases;

    fn message(only: Option<&str>, target: Option<&str>) -> String {
        let selected = select(cases::all(), only, target);
        selected.expect_err("nothing has such a name").to_string()
    }

    #[test]
    fn what_is_selected_has_the_texts() {
        let selected = select(cases::all(), Some("picture.dashboard"), Some("v7em")).unwrap();
        assert_eq!(selected.len(), 14);
        let is_right = |case: &Case| case.name.starts_with("picture.dashboard") && case.target == "thumbv7em-none-eabi";
        assert!(selected.iter().all(is_right));
        let all = cases::all().len();
        assert_eq!(select(cases::all(), None, None).map(|cases| cases.len()), Ok(all));
    }

    /// Each proposal can be asked for, and they fit on a screen.
    #[test]
    fn a_wrong_name_proposes_the_nearest() {
        for (only, nearest) in [
            ("pictures.dashboard", "picture.dashboard"),
            ("dashbord", "dashboard"),
            ("flesh", "flash"),
            ("line.onscreen", "line.on_screen"),
        ] {
            let message = message(Some(only), None);
            let proposals = message.split_once("there are: ").unwrap().1.lines().next().unwrap();
            assert_eq!(proposals.split(", ").next(), Some(nearest), "{message}");
            for proposal in proposals.split(", ") {
                assert!(select(cases::all(), Some(proposal), None).is_ok(), "{proposal}");
            }
            assert!(message.lines().count() <= 4 && message.len() < 400, "{message}");
        }
    }

    #[test]
    fn a_name_that_is_like_no_other_lists_the_families() {
        let message = message(Some("@"), Some("v7em"));
        for family in ["picture", "flash", "scene"] {
            assert!(message.contains(family), "{message}");
        }
        assert!(message.len() < 600, "{message}");
    }

    #[test]
    fn a_wrong_target_lists_those_with_such_a_name() {
        let message = message(Some("ram.cockpit"), Some("v6m"));
        assert!(
            message.contains("`ram.cockpit`") && message.ends_with("one of: thumbv7m-none-eabi"),
            "{message}"
        );
        let message = self::message(None, Some("riscv"));
        assert!(
            message.contains("`riscv`") && message.contains("thumbv6m-none-eabi"),
            "{message}"
        );
    }
}
