//! Demangles the names of linked functions, and tells by a name whether the function panics, and whose it is.

/// The crates of the firmware, as they are written in names.
const FIRMWARE: [&str; 2] = ["exercises::", "planted::"];

/// A symbol as Rust writes it, without hashes.
pub fn demangled(symbol: &str) -> String {
    format!("{:#}", rustc_demangle::demangle(symbol))
}

/// Whether a function of the core library does nothing but panic, or is the handler that every panic ends in.
pub fn is_panic(name: &str) -> bool {
    name.starts_with("core::panicking::") || name.ends_with("rust_begin_unwind")
}

/// Whether the source of a function is zrow's or the firmware's.
pub fn is_ours(name: &str) -> bool {
    let path = name.trim_start_matches(['<', '&']);
    path.starts_with("zrow::") || is_exercise(path)
}

/// Whether a function with this demangled name is one of the firmware's. Every chain of calls to a panic begins in one.
pub fn is_exercise(name: &str) -> bool {
    FIRMWARE.iter().any(|&firmware| name.starts_with(firmware))
}

/// The name with the paths of generic arguments cut to their last word: `a::b::<c::D<e::F>>` becomes `a::b::<D<F>>`.
pub fn shortened(name: &str) -> String {
    let mut short = String::new();
    let mut depth = 0usize;
    let mut word = 0;
    for (at, character) in name.char_indices() {
        match character {
            '<' => depth += 1,
            '>' if !short.ends_with('-') => depth = depth.saturating_sub(1),
            _ => {}
        }
        short.push(character);
        if !(character.is_alphanumeric() || character == '_' || character == ':') {
            word = short.len();
        } else if depth > 0 && short[word..].len() > 2 && short.ends_with("::") {
            // Another word follows, unless these are the arguments of a function.
            let rest = &name[at + 1..];
            if rest.starts_with(|next: char| next.is_alphabetic() || next == '_') {
                short.truncate(word);
            }
        }
    }
    short
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn symbols_become_paths() {
        let symbol = "_RNvNtNtCsQdPP0oC9wz_4core9panicking11panic_const23panic_const_div_by_zero";
        let name = demangled(symbol);
        assert_eq!(name, "core::panicking::panic_const::panic_const_div_by_zero");
        assert!(is_panic(&name) && !is_ours(&name));
        assert_eq!(
            demangled("_ZN4zrow4scan7ellipse9first_row17h0123456789abcdefE"),
            "zrow::scan::ellipse::first_row"
        );
    }

    #[test]
    fn what_is_ours_is_known_by_its_crate() {
        assert!(is_ours("zrow::scan::round::ellipse::first_row"));
        assert!(is_ours("<&zrow::coverage::Grid<4> as core::clone::Clone>::clone"));
        assert!(is_ours("exercises::scan::ellipse") && is_exercise("exercises::scan::ellipse"));
        assert!(!is_exercise("<exercises::band::AnyDisplay as zrow::band::Sink>::send"));
        assert!(!is_ours("<core::iter::Map<zrow::band::Band, u8>>::next"));
        assert!(!is_panic("core::slice::index::slice_index_fail"));
    }

    #[test]
    fn generic_arguments_lose_their_paths() {
        assert_eq!(
            shortened("zrow::scan::round::ellipse::first_row"),
            "zrow::scan::round::ellipse::first_row"
        );
        assert_eq!(
            shortened(
                "<zrow::draw::shapes::path::Path<zrow::geometry::Sub4> as zrow::draw::StyledShape>::draw_styled_on::<a::B<u8>>"
            ),
            "<Path<Sub4> as StyledShape>::draw_styled_on::<B<u8>>"
        );
        assert_eq!(
            shortened("exercises::draw::shape::<fn(a::B) -> c::D, e::F>"),
            "exercises::draw::shape::<fn(B) -> D, F>"
        );
        assert_eq!(
            shortened("<i32>::checked::<a::b<u8>::{closure#0}, <a::C as d::E>::Item>"),
            "<i32>::checked::<b<u8>::{closure#0}, <C as E>::Item>"
        );
    }
}
