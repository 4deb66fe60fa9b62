//! Shows a scene in a window until it is closed.

use super::options::Options;

/// Shows the scene that the options name.
#[cfg(feature = "window")]
pub fn show(options: &Options) -> anyhow::Result<()> {
    let mut shown = Shown {
        options,
        result: Ok(()),
    };
    options.visit(&mut shown);
    shown.result
}

/// Says how to get a simulator that has windows.
#[cfg(not(feature = "window"))]
pub fn show(_options: &Options) -> anyhow::Result<()> {
    anyhow::bail!(
        "this simulator was built without windows. With SDL2 installed (Debian: apt-get install libsdl2-dev) start it \
         as: cargo run --release --features window -- --window --scene NAME"
    )
}

#[cfg(feature = "window")]
struct Shown<'a> {
    options: &'a Options,
    result: anyhow::Result<()>,
}

#[cfg(feature = "window")]
impl zrow_scenes::Visitor for Shown<'_> {
    fn visit<S: zrow_scenes::Scene>(&mut self) {
        self.result = play::<S>(self.options);
    }
}

#[cfg(feature = "window")]
fn play<S: zrow_scenes::Scene>(options: &Options) -> anyhow::Result<()> {
    use embedded_graphics_simulator::{SimulatorDisplay, SimulatorEvent, Window};

    let settings = options.output_settings::<S>();
    let frames = options.frames::<S>();
    let mut display = SimulatorDisplay::with_default_color(S::AREA.size, S::BACKGROUND);
    let mut player = super::draw::Player::<S>::default();
    let mut window = Window::new(S::TITLE, &settings);
    for frame in (0..frames).cycle() {
        player.display(frame, &mut display)?;
        window.update(&display);
        if window.events().any(|event| event == SimulatorEvent::Quit) {
            break;
        }
        std::thread::sleep(std::time::Duration::from_millis(33));
    }
    Ok(())
}
