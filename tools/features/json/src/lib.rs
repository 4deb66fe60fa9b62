//! Nothing but dependencies: each program that reads or writes JSON asks for the same features of serde.
//!
//! As `zrow-features`, for the programs that are built without serde; a feature of that package would make it, and all that
//! depends on it, another one for those with serde.
