//! Which methods are worth their cost.

/// Error and cost of each; whether another one has no more of both and less of one.
pub fn dominated(figures: &[(f64, f64)]) -> Vec<bool> {
    let beats = |(error, cost): &(f64, f64), (other_error, other_cost): &(f64, f64)| {
        error <= other_error && cost <= other_cost && (error < other_error || cost < other_cost)
    };
    let is_dominated = |figure| figures.iter().any(|other| beats(other, figure));
    figures.iter().map(is_dominated).collect()
}

#[cfg(test)]
mod tests {
    use super::dominated;

    #[test]
    fn who_is_worse_in_one_and_better_in_none_is_dominated() {
        let figures = [(1.0, 10.0), (2.0, 10.0), (2.0, 5.0), (3.0, 6.0), (2.0, 5.0)];
        assert_eq!(dominated(&figures), [false, true, false, true, false]);
    }
}
