//! Each scene is the same picture, whether it is drawn in bands of any height or at once.

use core::convert::Infallible;

use embedded_graphics::geometry::Dimensions;
use zrow::band::{Band, BandColor, BigEndian, LittleEndian, Order};
use zrow_scenes::{Prepared, Scene, Visitor, visit};

type Word<S> = <<S as Scene>::Color as BandColor>::Word;

/// Colours of a whole picture, drawn into one band as high as the panel.
fn at_once<S: Scene>(scene: &mut S, frame: u32) -> Vec<S::Color> {
    let pixels = (S::AREA.size.width * S::AREA.size.height) as usize;
    let mut words = vec![blank::<S>(); pixels];
    let mut band = Band::<S::Color>::new(S::AREA, &mut words).expect("a word for each pixel");
    band.fill(S::BACKGROUND);
    scene
        .prepare(frame)
        .expect("the scene's tables hold it")
        .draw(&mut band);
    band.colors().collect()
}

/// Colours of a whole picture, drawn through the picture loop in bands of some rows.
fn in_bands<S: Scene, O: Order>(scene: &mut S, frame: u32, rows: u32) -> Vec<S::Color> {
    let picture = S::picture().rows(rows).in_order::<O>();
    let mut words = vec![blank::<S>(); picture.words_needed()];
    let mut prepared = scene.prepare(frame).expect("the scene's tables hold it");
    let mut colors = Vec::new();
    let mut sink = |band: Band<'_, S::Color, O>| {
        assert!(band.bounding_box().size.height <= rows);
        colors.extend(band.colors());
        Ok::<(), Infallible>(())
    };
    picture
        .draw(&mut words, &mut sink, |band| prepared.draw(band))
        .expect("the words suffice");
    colors
}

fn blank<S: Scene>() -> Word<S> {
    S::BACKGROUND.to_word()
}

struct Compare;

impl Visitor for Compare {
    fn visit<S: Scene>(&mut self) {
        let mut scene = S::default();
        for frame in [0, 1, S::FRAMES / 3, S::FRAMES - 1] {
            let whole = at_once(&mut scene, frame);
            assert_picture::<S>(&whole);
            for rows in [1, 2, 7, 16, S::AREA.size.height] {
                let banded = in_bands::<S, LittleEndian>(&mut scene, frame, rows);
                assert!(whole == banded, "{} in bands of {rows} rows, frame {frame}", S::NAME);
            }
            let swapped = in_bands::<S, BigEndian>(&mut scene, frame, 3);
            assert!(whole == swapped, "{} in big-endian words, frame {frame}", S::NAME);
        }
    }
}

/// Something was drawn.
fn assert_picture<S: Scene>(colors: &[S::Color]) {
    let drawn = colors.iter().filter(|&&color| color != S::BACKGROUND).count();
    assert!(drawn * 50 > colors.len(), "{} is nearly empty", S::NAME);
}

#[test]
fn every_scene_in_bands_of_any_height() {
    visit(None, &mut Compare);
}

struct Count(usize);

impl Visitor for Count {
    fn visit<S: Scene>(&mut self) {
        self.0 += 1;
        assert!(S::PORTRAIT < S::FRAMES, "{}", S::NAME);
        assert!(!S::TITLE.is_empty(), "{}", S::NAME);
    }
}

#[test]
fn names_find_their_scenes() {
    let mut all = Count(0);
    visit(None, &mut all);
    assert_eq!(all.0, zrow_scenes::NAMES.len());
    for (index, name) in zrow_scenes::NAMES.iter().enumerate() {
        let mut one = Count(0);
        visit(Some(name), &mut one);
        assert_eq!(one.0, 1, "{name}");
        assert!(!zrow_scenes::NAMES[..index].contains(name), "{name} twice");
    }
    let mut none = Count(0);
    visit(Some("no such scene"), &mut none);
    assert_eq!(none.0, 0);
}

struct EveryFrame;

impl Visitor for EveryFrame {
    fn visit<S: Scene>(&mut self) {
        let mut scene = S::default();
        for frame in 0..=S::FRAMES {
            assert!(scene.prepare(frame).is_ok(), "{} frame {frame}", S::NAME);
        }
        // The animation repeats, also where numbers end.
        let first = at_once(&mut scene, 0);
        assert!(first == at_once(&mut scene, S::FRAMES), "{}", S::NAME);
        assert!(scene.prepare(u32::MAX).is_ok(), "{}", S::NAME);
    }
}

#[test]
fn every_frame_fits_its_tables_and_the_animation_repeats() {
    visit(None, &mut EveryFrame);
}
