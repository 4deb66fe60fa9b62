//! Indexed face sets, as they lie in flash.
