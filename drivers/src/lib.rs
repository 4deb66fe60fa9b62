//! Display drivers over recording wires: the tests of this package, which has no code of its own.
