//! A picture in one-row bands through each driver, with the lines that a program writes, and what comes out of the wires.

mod layouts;
mod lcds;
mod oleds;
mod papers;
mod scene;
mod wires;
mod wires_02;
