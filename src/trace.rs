//! The library's only trace macro: reaches the debug probe with the feature `defmt`, and is nothing without it.

/// Logs through `defmt::trace!` where the feature is on. The arguments are not evaluated without it.
macro_rules! trace {
    ($format:literal $(, $argument:expr)* $(,)?) => {{
        #[cfg(feature = "defmt")]
        defmt::trace!($format $(, $argument)*);
        #[cfg(not(feature = "defmt"))]
        {
            // Names the arguments, so that a variable that is only traced is not unused.
            let _ = || { $(let _ = &$argument;)* };
        }
    }};
}
