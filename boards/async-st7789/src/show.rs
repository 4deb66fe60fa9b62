//! Two scenes in turn: a panel of antialiased instruments, of which only the rectangles that change are sent, and the Utah teapot,
//! lit and textured.

use core::convert::Infallible;

use embedded_graphics::{pixelcolor::Rgb565, primitives::Rectangle};
use embedded_hal::{digital::OutputPin, spi::SpiBus};
use zrow::{
    band::{Band, BigEndian, LoopError, PictureLoop},
    geometry::Window,
    scene::Counters,
};
use zrow_scenes::{
    PrepareError, Prepared, Scene,
    instruments::{Changing, DAMAGE_AREAS, Instruments},
    teapots::CountedTeapot,
};

use crate::{Error, Panel};

/// Frames of a scene before the next one follows.
const FRAMES: u32 = 64;

/// A frame that was sent.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Frame {
    /// The instruments: what of them has changed.
    Instruments {
        /// The number of the frame.
        frame: u32,
        /// Rectangles that were drawn and sent.
        areas: u32,
        /// The pixels in them.
        pixels: u32,
    },
    /// The teapot.
    Teapot {
        /// The number of the frame.
        frame: u32,
        /// The work that drawing the frame took.
        counters: Counters,
    },
}

/// Why the pictures stopped; `E` is the error of the bus.
#[derive(Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Failure<E> {
    /// The memory of a scene is too small.
    Scene(PrepareError),
    /// A band could not be drawn or sent.
    Picture(LoopError<Error<E>>),
}

impl<E> From<PrepareError> for Failure<E> {
    fn from(error: PrepareError) -> Self {
        Self::Scene(error)
    }
}

impl<E> From<LoopError<Error<E>>> for Failure<E> {
    fn from(error: LoopError<Error<E>>) -> Self {
        Self::Picture(error)
    }
}

/// Shows one scene after the other, for ever, and reports each frame that was sent. A band has as many rows as a buffer has room
/// for; a row of 240 words will do.
///
/// # Errors
/// The panel fails, or a buffer has no room for a row.
pub async fn show_scenes<BUS, P>(
    panel: &mut Panel<BUS, P>,
    [one, other]: [&mut [u16]; 2],
    mut report: impl FnMut(Frame),
) -> Result<Infallible, Failure<BUS::Error>>
where
    BUS: SpiBus + embedded_hal_async::spi::SpiBus,
    P: OutputPin<Error = Infallible>,
{
    loop {
        show_instruments(panel, [&mut *one, &mut *other], &mut report).await?;
        show_teapot(panel, [&mut *one, &mut *other], &mut report).await?;
    }
}

/// Sends the instruments once, and what changes in each frame from then on.
async fn show_instruments<BUS, P>(
    panel: &mut Panel<BUS, P>,
    [one, other]: [&mut [u16]; 2],
    report: &mut impl FnMut(Frame),
) -> Result<(), Failure<BUS::Error>>
where
    BUS: SpiBus + embedded_hal_async::spi::SpiBus,
    P: OutputPin<Error = Infallible>,
{
    let mut scene = Instruments::new();
    let mut damage = [Window::EMPTY; DAMAGE_AREAS];
    let mut picture = scene.picture_with_damage(&mut damage);
    let changing = Changing::add(&mut picture, 0)?;
    for frame in 0..FRAMES {
        changing.show(&mut picture, frame)?;
        let (mut areas, mut pixels) = (0, 0);
        while let Some(area) = picture.next_damage() {
            let whole = (area, Instruments::BACKGROUND);
            draw(panel, whole, [&mut *one, &mut *other], |band| {
                Prepared::draw(&mut picture, band);
            })
            .await?;
            areas += 1;
            pixels += area.size.width * area.size.height;
        }
        report(Frame::Instruments { frame, areas, pixels });
    }
    Ok(())
}

/// Sends each frame of the teapot whole.
async fn show_teapot<BUS, P>(
    panel: &mut Panel<BUS, P>,
    [one, other]: [&mut [u16]; 2],
    report: &mut impl FnMut(Frame),
) -> Result<(), Failure<BUS::Error>>
where
    BUS: SpiBus + embedded_hal_async::spi::SpiBus,
    P: OutputPin<Error = Infallible>,
{
    let mut scene = CountedTeapot::default();
    for frame in 0..FRAMES {
        let mut prepared = scene.prepare(frame)?;
        let whole = (CountedTeapot::AREA, CountedTeapot::BACKGROUND);
        draw(panel, whole, [&mut *one, &mut *other], |band| prepared.draw(band)).await?;
        let counters = prepared.counters();
        report(Frame::Teapot { frame, counters });
    }
    Ok(())
}

/// Draws an area over its background, each band while the one before it is sent.
async fn draw<BUS, P>(
    panel: &mut Panel<BUS, P>,
    (area, background): (Rectangle, Rgb565),
    buffers: [&mut [u16]; 2],
    scene: impl FnMut(&mut Band<'_, Rgb565, BigEndian>),
) -> Result<(), LoopError<Error<BUS::Error>>>
where
    BUS: SpiBus + embedded_hal_async::spi::SpiBus,
    P: OutputPin<Error = Infallible>,
{
    let words = buffers[0].len().min(buffers[1].len()) as u32;
    let rows = (words / area.size.width.max(1)).clamp(1, area.size.height.max(1));
    let send = async |area: Rectangle, bytes: &[u8]| panel.send(area, bytes).await;
    PictureLoop::new(area, background)
        .rows(rows)
        .in_order::<BigEndian>()
        .draw_async(buffers, send, scene)
        .await
}
