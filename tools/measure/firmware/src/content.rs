//! What a program for footprints links: the one thing that the variable `ZROW_FOOTPRINT` names while it is built.

/// What is named; everything or nothing, as the program has it, where it is `None`.
const CHOSEN: Option<&str> = option_env!("ZROW_FOOTPRINT");

/// Whether something is named.
pub const IS_ANY: bool = CHOSEN.is_some();

/// Whether this is what is named. In a `const` block it decides what is linked.
pub const fn is(name: &str) -> bool {
    let Some(chosen) = CHOSEN else { return false };
    let (mut chosen, mut name) = (chosen.as_bytes(), name.as_bytes());
    while let ([one, chosen_rest @ ..], [other, name_rest @ ..]) = (chosen, name) {
        if *one != *other {
            return false;
        }
        (chosen, name) = (chosen_rest, name_rest);
    }
    chosen.is_empty() && name.is_empty()
}
