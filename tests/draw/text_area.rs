//! What tests of text share: layouts, a pattern to draw on, in one piece, in bands and from a picture, and what any target gets.

use embedded_graphics::{
    Pixel,
    pixelcolor::Rgb565,
    prelude::*,
    primitives::Rectangle,
    text::{
        Alignment, Baseline, DecorationColor, LineHeight, Text, TextStyle, TextStyleBuilder,
        renderer::{CharacterStyle, TextRenderer},
    },
};
use zrow::{band::Band, draw::Picture};

use crate::common::picture;

pub const ALIGNMENTS: [Alignment; 3] = [Alignment::Left, Alignment::Center, Alignment::Right];
pub const BASELINES: [Baseline; 4] = [Baseline::Top, Baseline::Bottom, Baseline::Middle, Baseline::Alphabetic];

pub fn layout(alignment: usize, baseline: usize, line_height: LineHeight) -> TextStyle {
    TextStyleBuilder::new()
        .alignment(ALIGNMENTS[alignment % 3])
        .baseline(BASELINES[baseline % 4])
        .line_height(line_height)
        .build()
}

/// A style by bits: with text, with a background, underlined, struck through.
pub fn with_bits<S: CharacterStyle<Color = Rgb565>>(mut style: S, bits: u8) -> S {
    style.set_text_color((bits & 1 != 0).then_some(Rgb565::YELLOW));
    style.set_background_color((bits & 2 != 0).then_some(Rgb565::BLUE));
    style.set_underline_color(if bits & 4 != 0 {
        DecorationColor::TextColor
    } else {
        DecorationColor::None
    });
    style.set_strikethrough_color(if bits & 8 != 0 {
        DecorationColor::Custom(Rgb565::GREEN)
    } else {
        DecorationColor::None
    });
    style
}

/// A pattern of colours, which depends on the position alone.
pub fn below(point: Point) -> Rgb565 {
    let bits = point.x.wrapping_mul(7) ^ point.y.wrapping_mul(13);
    Rgb565::new(bits as u8 & 31, (bits >> 2) as u8 & 63, (bits >> 3) as u8 & 31)
}

/// Draws on a band over the pattern.
pub fn on_pattern(window: Rectangle, draw: impl FnOnce(&mut Band<'_, Rgb565>)) -> Vec<Rgb565> {
    picture(window, |band| {
        let Ok(()) = band.draw_iter(window.points().map(|point| Pixel(point, below(point))));
        draw(band);
    })
}

/// Draws over the pattern in bands of this height, from the last one up or from the first one down.
pub fn in_bands(
    window: Rectangle,
    height: u32,
    upwards: bool,
    mut draw: impl FnMut(&mut Band<'_, Rgb565>),
) -> Vec<Rgb565> {
    let mut tops: Vec<u32> = (0..window.size.height).step_by(height as usize).collect();
    if upwards {
        tops.reverse();
    }
    let mut drawn: Vec<(u32, Vec<Rgb565>)> = tops
        .into_iter()
        .map(|top| {
            let size = Size::new(window.size.width, height.min(window.size.height - top));
            let area = Rectangle::new(window.top_left + Size::new(0, top), size);
            (top, on_pattern(area, &mut draw))
        })
        .collect();
    drawn.sort_by_key(|(top, _)| *top);
    drawn.into_iter().flat_map(|(_, band)| band).collect()
}

/// Draws a picture over the pattern in bands of this height, from the last one up and then from the first one down.
pub fn prepared(window: Rectangle, height: u32, picture: &mut Picture<'_, '_, Rgb565>) -> [Vec<Rgb565>; 2] {
    [true, false].map(|upwards| in_bands(window, height, upwards, |band| picture.draw(band)))
}

/// The pixels of a window among those of a larger one.
pub fn cut(whole: &[Rgb565], around: Rectangle, window: Rectangle) -> Vec<Rgb565> {
    let pixels = around.points().zip(whole);
    pixels
        .filter(|(point, _)| window.contains(*point))
        .map(|(_, word)| *word)
        .collect()
}

/// A display that cannot be read back, on which the last colour of each pixel stays.
pub struct Recorder {
    pub area: Rectangle,
    pub colors: Vec<Rgb565>,
}

impl Dimensions for Recorder {
    fn bounding_box(&self) -> Rectangle {
        self.area
    }
}

impl DrawTarget for Recorder {
    type Color = Rgb565;
    type Error = core::convert::Infallible;

    fn draw_iter<I: IntoIterator<Item = Pixel<Rgb565>>>(&mut self, pixels: I) -> Result<(), Self::Error> {
        for Pixel(point, color) in pixels {
            if self.area.contains(point) {
                let at = point - self.area.top_left;
                self.colors[at.y as usize * self.area.size.width as usize + at.x as usize] = color;
            }
        }
        Ok(())
    }
}

/// What embedded-graphics draws with a style, over the pattern, and where the next text would begin.
pub fn recorded<S: TextRenderer<Color = Rgb565>>(window: Rectangle, text: &Text<'_, S>) -> (Vec<Rgb565>, Point) {
    let colors = window.points().map(below).collect();
    let mut recorder = Recorder { area: window, colors };
    let Ok(next) = text.draw(&mut recorder);
    (recorder.colors, next)
}

/// Checks that whatever a text changes lies in the box that the style measures, and that both say where the next one begins.
pub fn check_metrics<S: TextRenderer<Color = Rgb565> + Copy>(
    text: &str,
    style: S,
    baseline: Baseline,
    drawn: &dyn Fn(Rectangle, &Text<'_, S>) -> Vec<Rgb565>,
) {
    let window = Rectangle::new(Point::zero(), Size::new(200, 80));
    let position = Point::new(40, 40);
    let metrics = style.measure_string(text, position, baseline);
    let text = Text::with_baseline(text, position, style, baseline);
    let pixels = window.points().zip(drawn(window, &text));
    for (point, _) in pixels.filter(|&(point, color)| color != below(point)) {
        assert!(
            metrics.bounding_box.contains(point),
            "{:?}: {point} not in {metrics:?}",
            text.text
        );
    }
    assert_eq!(recorded(window, &text).1, metrics.next_position);
    if let Some(corner) = metrics.bounding_box.bottom_right() {
        assert!(corner.x + 1 >= metrics.next_position.x);
    }
}
