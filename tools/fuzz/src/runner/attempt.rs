//! One input of a target: what came of it.

use std::{
    cell::RefCell,
    panic::{self, AssertUnwindSafe, PanicHookInfo},
};

use serde::{Deserialize, Serialize};

use crate::target::Target;

/// What went wrong with an input.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub enum Wrong {
    /// A panic, and where in the source.
    Panic {
        /// File and line.
        location: String,
        /// Its message.
        message: String,
    },
    /// A property that does not hold.
    Property(String),
    /// It takes longer than the limit, in milliseconds.
    Slow(u64),
    /// The process ended: a stack overflow, or an abort.
    Ended(String),
}

impl Wrong {
    /// What two inputs have in common that go wrong in the same way: the location of a panic, or a message without its numbers.
    pub fn kind(&self) -> String {
        match self {
            Self::Panic { location, .. } => format!("panic at {location}"),
            Self::Property(message) => {
                let words = message.split(|character: char| !character.is_alphabetic());
                words.filter(|word| !word.is_empty()).collect::<Vec<_>>().join(" ")
            }
            Self::Slow(_) => "slow".to_owned(),
            Self::Ended(_) => "ended".to_owned(),
        }
    }
}

impl std::fmt::Display for Wrong {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Panic { location, message } => write!(formatter, "panics at {location}: {message}"),
            Self::Property(message) => formatter.write_str(message),
            Self::Slow(limit) => write!(formatter, "takes more than {limit} ms"),
            Self::Ended(how) => write!(formatter, "ends the process: {how}"),
        }
    }
}

thread_local! {
    static LAST_PANIC: RefCell<Option<Wrong>> = const { RefCell::new(None) };
}

fn note(info: &PanicHookInfo<'_>) {
    let location = info
        .location()
        .map(|location| format!("{}:{}", location.file(), location.line()));
    let message = info.payload_as_str().unwrap_or("no message").to_owned();
    let wrong = Wrong::Panic {
        location: location.unwrap_or_default(),
        message,
    };
    LAST_PANIC.with(|last| last.replace(Some(wrong)));
}

/// From now on panics are noted and not printed.
pub fn note_panics() {
    panic::set_hook(Box::new(note));
}

/// Checks an input; a panic is caught, and with [`note_panics`] it says where it came from.
pub fn attempt(target: &Target, bytes: &[u8]) -> Result<(), Wrong> {
    let checked = panic::catch_unwind(AssertUnwindSafe(|| target.check(bytes)));
    match checked {
        Ok(Ok(())) => Ok(()),
        Ok(Err(error)) => Err(Wrong::Property(format!("{error:#}"))),
        Err(_) => Err(LAST_PANIC.with(RefCell::take).unwrap_or(Wrong::Panic {
            location: String::new(),
            message: String::new(),
        })),
    }
}
