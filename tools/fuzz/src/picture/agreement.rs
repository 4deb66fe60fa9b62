//! All ways to draw a picture, which must give the same one: in bands of any height, through a smaller window, in the other
//! byte order, through [`Generic`] on a display, and on a display that failed before.

use std::convert::Infallible;

use anyhow::{Context, bail, ensure};
use embedded_graphics::{
    geometry::Point,
    pixelcolor::{Rgb565, RgbColor},
    prelude::{Dimensions, Drawable, Primitive},
    primitives::{PointsIter, Styled, StyledDimensions, StyledDrawable},
};
use zrow::{
    band::{Band, BigEndian, Generic, LittleEndian, Order},
    draw::{DrawOn, PrimitiveStyle},
    geometry::Window,
};

use crate::{
    picture::{Canvas, Sheet, Stopped, UsersTarget, canvas::background},
    target::Verdict,
    values::{Stage, Style},
};

/// How much a drawing may ask of a display.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
pub struct Work {
    /// Parts that are drawn one over the other, each of which may take every pixel of the window once.
    pub parts: u64,
}

impl Work {
    /// Each pixel once at most.
    pub const ONCE: Self = Self { parts: 1 };

    /// That many parts, one over the other.
    pub const fn parts(parts: usize) -> Self {
        Self { parts: parts as u64 }
    }

    /// Pixels that may come for a window.
    const fn pixels(self, window: &Window) -> u64 {
        self.parts * window.width() as u64 * window.height() as u64
    }

    /// Calls that may come for a window: a part is at worst drawn pixel by pixel.
    const fn calls(self, window: &Window) -> u64 {
        self.pixels(window)
    }
}

/// What can be drawn on a band of either byte order.
pub trait OnBand {
    /// Draws what is inside the band.
    ///
    /// # Errors
    /// Says what should not have happened.
    fn draw_on_band<O: Order>(&self, band: &mut Band<'_, Rgb565, O>) -> Verdict;
}

/// What draws itself on any target.
struct Drawing<'d, D>(&'d D);

impl<D: DrawOn<Color = Rgb565>> OnBand for Drawing<'_, D> {
    fn draw_on_band<O: Order>(&self, band: &mut Band<'_, Rgb565, O>) -> Verdict {
        let Ok(()) = self.0.draw_on(band);
        Ok(())
    }
}

/// The picture in one band.
///
/// # Errors
/// The drawing's.
pub fn full_picture(window: Window, drawing: &impl DrawOn<Color = Rgb565>) -> anyhow::Result<Vec<Rgb565>> {
    Canvas::new(window).draw::<LittleEndian>(|band| Drawing(drawing).draw_on_band(band))
}

/// Draws a picture in one band, in bands of one row and of several, through a smaller window, and in the other byte order:
/// all of them are the same. Returns it.
///
/// # Errors
/// Says which differ, and where.
pub fn agree_on_bands(stage: &Stage, drawing: &impl OnBand) -> anyhow::Result<Vec<Rgb565>> {
    let window = stage.window;
    let full = Canvas::new(window).draw::<LittleEndian>(|band| drawing.draw_on_band(band))?;
    let other_order = Canvas::new(window).draw::<BigEndian>(|band| drawing.draw_on_band(band))?;
    is_same(&window, &full, &other_order).context("one band, the other in big-endian order")?;
    for rows in [1, stage.rows] {
        for band in stage.bands(rows) {
            let picture = Canvas::new(band).draw::<LittleEndian>(|band| drawing.draw_on_band(band))?;
            is_same(&band, &cut(&window, &full, &band), &picture)
                .with_context(|| format!("one band, the other in bands of {rows} rows"))?;
        }
    }
    let part = Canvas::new(stage.part).draw::<LittleEndian>(|band| drawing.draw_on_band(band))?;
    is_same(&stage.part, &cut(&window, &full, &stage.part), &part).context("one band, the other a part of it")?;
    Ok(full)
}

/// Draws a picture in all ways, on bands and on a display: they are the same. The display is asked for no more than `work`,
/// for nothing outside of it, and for nothing after it failed; when it works again, the picture is drawn whole. Returns it.
///
/// # Errors
/// Says which differ, and where.
pub fn agree(stage: &Stage, drawing: &impl DrawOn<Color = Rgb565>, work: Work) -> anyhow::Result<Vec<Rgb565>> {
    let window = stage.window;
    let full = agree_on_bands(stage, &Drawing(drawing))?;
    let empty = Sheet::new(window, background()).with_most(work.calls(&window), work.pixels(&window));
    let mut sheet = empty.clone();
    is_drawn(drawing.draw_on(&mut Generic(&mut sheet)), &sheet, &full, work)
        .context("one band, the other on a display")?;
    let mut users = empty.clone();
    let drawn = drawing.draw_on(&mut Generic(&mut UsersTarget::new(&mut users)));
    is_drawn(drawn, &users, &full, work).context("one band, the other on a user's own display")?;
    if let Some(call) = u64::from(stage.rows).checked_rem(sheet.calls) {
        let mut failing = empty.failing_at(call);
        let result = drawing.draw_on(&mut Generic(&mut failing));
        ensure!(result == Err(Stopped::AsTold), "the display's error gets lost");
        failing.was_treated_well()?;
        failing.mend();
        ensure!(
            drawing.draw_on(&mut Generic(&mut failing)).is_ok(),
            "no second drawing after an error"
        );
        is_same(&window, &full, failing.pixels()).context("drawn at once, the other again after an error")?;
    }
    Ok(full)
}

/// Whether a sheet has that picture, and was not asked for more than the work.
fn is_drawn(drawn: Result<(), Stopped>, sheet: &Sheet<Rgb565>, picture: &[Rgb565], work: Work) -> Verdict {
    match drawn {
        Ok(()) => {}
        Err(Stopped::TooMuchWork) => bail!(
            "{} calls and {} pixels for {} pixels of the window in {} parts",
            sheet.calls,
            sheet.taken,
            picture.len(),
            work.parts
        ),
        Err(Stopped::AsTold) => bail!("an error that nobody told"),
    }
    sheet.was_treated_well()?;
    is_same(&sheet.bounding_box().into(), picture, sheet.pixels())?;
    ensure!(work != Work::ONCE || sheet.most_writes() <= 1, "a pixel is drawn twice");
    Ok(())
}

/// As [`agree`], for a shape in a style; `Drawable::draw` gives the same picture, and its bounding box has all pixels.
///
/// # Errors
/// Says which differ, and where.
pub fn agree_styled<S>(stage: &Stage, shape: S, style: Style, work: Work) -> anyhow::Result<Vec<Rgb565>>
where
    S: Primitive + Clone,
    Styled<S, PrimitiveStyle<Rgb565>>: DrawOn<Color = Rgb565>,
    S: StyledDrawable<PrimitiveStyle<Rgb565>, Color = Rgb565, Output = ()>,
    S: StyledDimensions<PrimitiveStyle<Rgb565>>,
{
    let styled = shape.into_styled(style.get());
    let full = agree(stage, &styled, work)?;
    agree_with_drawable(stage, &full, &styled)?;
    Ok(full)
}

/// `Drawable::draw` gives the picture too, and all of it lies in the bounding box.
///
/// # Errors
/// It does not.
pub fn agree_with_drawable<D>(stage: &Stage, full: &[Rgb565], drawable: &D) -> Verdict
where
    D: Drawable<Color = Rgb565, Output = ()> + Dimensions,
{
    let mut sheet = Sheet::new(stage.window, background());
    ensure!(drawable.draw(&mut sheet).is_ok(), "an error that nobody told");
    is_same(&stage.window, full, sheet.pixels()).context("one band, the other by Drawable::draw")?;
    let bounds = drawable.bounding_box();
    let outside = stage.area().points().zip(full).find(|&(point, &color)| {
        let window = Window::from(bounds);
        // A window has no last column and row of `i32::MAX`; neither has a picture.
        color != background() && !window.contains(point)
    });
    ensure!(
        outside.is_none(),
        "{:?} is drawn outside of the bounding box {bounds:?}",
        outside.map(|(point, _)| point)
    );
    let on_band = Canvas::new(stage.window).draw::<LittleEndian>(|band| {
        // What does not meet the band is left out: it has no pixels there.
        let (None | Some(())) = band.draw(drawable);
        Ok(())
    })?;
    is_same(&stage.window, full, &on_band).context("one band, the other by Band::draw")
}

/// The part of a picture that a smaller window shows.
pub fn cut(window: &Window, picture: &[Rgb565], part: &Window) -> Vec<Rgb565> {
    let points = window.to_rectangle().points();
    let pixels = points.zip(picture);
    pixels
        .filter(|(point, _)| part.contains(*point))
        .map(|(_, color)| *color)
        .collect()
}

/// Whether two pictures of a window are the same.
///
/// # Errors
/// Says how many pixels differ, and where the first one is.
pub fn is_same(window: &Window, expected: &[Rgb565], found: &[Rgb565]) -> Verdict {
    ensure!(
        expected.len() == found.len(),
        "{} pixels, the other {}",
        expected.len(),
        found.len()
    );
    let pixels = window.to_rectangle().points().zip(expected.iter().zip(found));
    let mut differing = pixels.filter(|(_, (expected, found))| expected != found);
    let Some((Point { x, y }, (expected, found))) = differing.next() else {
        return Ok(());
    };
    let in_words = |color: &Rgb565| format!("{:02x}/{:02x}/{:02x}", color.r(), color.g(), color.b());
    bail!(
        "({x}, {y}) is {}, the other {}; {} pixels differ",
        in_words(expected),
        in_words(found),
        differing.count() + 1
    )
}

/// A drawing that cannot fail.
pub fn sure<T>(result: Result<T, Infallible>) -> T {
    let Ok(value) = result;
    value
}
