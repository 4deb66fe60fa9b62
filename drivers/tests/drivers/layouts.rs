//! Crates that lay out by the box of what they draw into, in one-row bands.

use std::convert::Infallible;

use embedded_graphics::{
    mono_font::{MonoTextStyle, ascii::FONT_6X10},
    pixelcolor::Rgb565,
    prelude::*,
    primitives::{Circle, PrimitiveStyle, Rectangle},
    text::Text,
};
use zrow::band::{Band, PictureLoop};

use crate::scene::box_of;

/// A layout that asks the target for its box, in one-row bands.
#[test]
fn embedded_layout_in_the_picture() {
    use embedded_layout::{layout::linear::LinearLayout, prelude::*};

    fn layout<D: DrawTarget<Color = Rgb565>>(target: &mut D) -> Result<(), D::Error> {
        let text = Text::new("zrow", Point::zero(), MonoTextStyle::new(&FONT_6X10, Rgb565::WHITE));
        let disc = Circle::new(Point::zero(), 15).into_styled(PrimitiveStyle::with_fill(Rgb565::RED));
        LinearLayout::vertical(Chain::new(text).append(disc))
            .with_alignment(horizontal::Center)
            .arrange()
            .align_to(&target.bounding_box(), horizontal::Center, vertical::Center)
            .draw(target)
    }

    let area = box_of(64, 48);
    let mut whole = vec![0; 64 * 48];
    let Ok(()) = layout(&mut Band::<Rgb565>::new(area, &mut whole).unwrap());
    assert!(whole.contains(&Rgb565::RED.into_storage()));
    let sent = in_one_row_bands(area, |band| {
        let Ok(()) = layout(&mut band.in_picture(area));
    });
    assert!(sent == whole);
}

/// A user interface whose widgets take their places from the box of the target, in one-row bands.
#[test]
fn kolibri_in_the_picture() {
    use kolibri_embedded_gui::{button::Button, label::Label, style::medsize_rgb565_style, ui::Ui};

    fn show<D: DrawTarget<Color = Rgb565>>(target: &mut D) {
        let mut ui = Ui::new_fullscreen(target, medsize_rgb565_style());
        assert!(ui.clear_background().is_ok());
        ui.add(Label::new("zrow"));
        ui.add(Button::new("Start"));
    }

    let area = box_of(160, 120);
    let mut whole = vec![0; 160 * 120];
    show(&mut Band::<Rgb565>::new(area, &mut whole).unwrap());
    assert!(whole.iter().filter(|word| **word != whole[0]).count() > 500);
    assert!(in_one_row_bands(area, |band| show(&mut band.in_picture(area))) == whole);
}

/// The words of a picture that is drawn in bands of one row.
fn in_one_row_bands(area: Rectangle, mut scene: impl FnMut(&mut Band<'_, Rgb565>)) -> Vec<u16> {
    let (mut row, mut sent) = (vec![0; area.size.width as usize], Vec::new());
    let mut sink = |band: Band<'_, Rgb565>| {
        sent.extend_from_slice(band.words());
        Ok::<(), Infallible>(())
    };
    PictureLoop::new(area, Rgb565::BLACK)
        .draw(&mut row, &mut sink, |band| scene(band))
        .unwrap();
    sent
}
