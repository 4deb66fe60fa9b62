//! Demangles the names of linked functions, and tells by a name whether the function panics or divides, and whose it is.

/// The crates of the firmware, as they are written in names.
const FIRMWARE: [&str; 4] = ["exercises::", "planted::", "orthographic::", "perspective::"];

/// A symbol as Rust writes it, without hashes.
pub fn demangled(symbol: &str) -> String {
    format!("{:#}", rustc_demangle::demangle(symbol))
}

/// Whether a function of the core library does nothing but panic, or is the handler that every panic ends in.
pub fn is_panic(name: &str) -> bool {
    name.starts_with("core::panicking::") || name.ends_with("rust_begin_unwind")
}

/// Whether a function divides: a routine of the compiler for chips without a divider, or one of zrow's own.
pub fn is_division(name: &str) -> bool {
    let is_of_zrow = name.strip_prefix("zrow::geometry::division::").is_some_and(|function| {
        let parts = ["divide", "quotient", "reciprocal", "remainder"];
        parts.iter().any(|part| function.starts_with(part))
    });
    let is_of_runtime = name.strip_prefix("__").is_some_and(|function| {
        let runtime = function.strip_prefix("aeabi_").unwrap_or(function);
        let signs = ["i", "l", "u", "ui", "ul"];
        signs.iter().any(|sign| {
            let rest = runtime.strip_prefix(sign);
            rest.is_some_and(|rest| rest.starts_with("div") || rest.starts_with("mod"))
        }) || runtime.starts_with("div")
            || runtime.starts_with("mod")
    });
    is_of_zrow || is_of_runtime || (name.starts_with("compiler_builtins::") && name.contains("div_rem"))
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
    fn divisions_are_known_by_their_names() {
        for name in [
            "__aeabi_uidiv",
            "__aeabi_idivmod",
            "__aeabi_ldivmod",
            "__aeabi_uldivmod",
            "__udivsi3",
            "__divdi3",
            "__umodsi3",
            "__udivmoddi4",
            "compiler_builtins::int::specialized_div_rem::u64_div_rem",
            "zrow::geometry::division::reciprocal_16_by_newton",
            "zrow::geometry::division::divide_long",
        ] {
            assert!(is_division(name), "{name}");
        }
        for name in [
            "__aeabi_lmul",
            "__aeabi_memcpy",
            "zrow::geometry::division::multiply_shift_by_halves",
            "zrow::scene::prepare::transform_model",
        ] {
            assert!(!is_division(name), "{name}");
        }
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
