//! Demo scenes, shared by every board: the same code draws on the desktop and in firmware.
#![no_std]
#![forbid(unsafe_code)]

pub mod oled;
