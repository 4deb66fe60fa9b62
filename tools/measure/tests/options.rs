//! The command line of `measure`, as a user types it.

use std::process::Command;

/// A wrong name is answered as any other wrong option is, also where backtraces are asked for.
#[test]
fn a_name_that_nothing_has_is_a_short_error() {
    for (options, proposed) in [
        (["--only", "pictures.dashbord"], "picture.dashboard"),
        (["--only", "@"], "one of: arc, "),
        (["--target", "riscv"], "thumbv7em-none-eabi"),
    ] {
        let mut command = Command::new(env!("CARGO_BIN_EXE_zrow-measure"));
        let output = command.args(options).env("RUST_BACKTRACE", "1").output();
        let output = output.expect("measure runs");
        let message = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{message}");
        assert!(output.stdout.is_empty());
        assert!(
            message.starts_with("error: nothing ") && message.contains(proposed),
            "{message}"
        );
        assert!(
            message.lines().count() < 10 && !message.contains("backtrace"),
            "{message}"
        );
    }
}
