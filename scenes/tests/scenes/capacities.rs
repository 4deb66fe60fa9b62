//! Scenes that are pictures lend as much as their frames take.

use core::convert::Infallible;

use zrow::band::{Band, BandColor};
use zrow_scenes::{PictureCapacities, Prepared, Scene, Visitor, visit};

/// The most that one of the frames takes, each drawn row by row; `None` where the scene is no picture.
fn used<S: Scene>() -> Option<PictureCapacities> {
    let (mut scene, picture) = (S::default(), S::picture());
    let mut row = vec![S::BACKGROUND.to_word(); picture.words_needed()];
    let mut sink = |_: Band<'_, S::Color>| Ok::<(), Infallible>(());
    let frames = (0..S::FRAMES).map(|frame| {
        let mut prepared = scene.prepare(frame).expect("the scene's tables hold it");
        picture
            .draw(&mut row, &mut sink, |band| prepared.draw(band))
            .expect("a word for each column");
        prepared.capacities_used()
    });
    frames
        .reduce(|one, other| one.zip(other).map(|(one, other)| one.max(other)))
        .flatten()
}

/// The names of the pictures that were visited.
#[derive(Default)]
struct Pictures(Vec<&'static str>);

impl Visitor for Pictures {
    fn visit<S: Scene>(&mut self) {
        let (used, lent) = (used::<S>(), S::PICTURE);
        assert_eq!(used.is_some(), lent.is_some(), "{}", S::NAME);
        let Some((used, lent)) = used.zip(lent) else { return };
        self.0.push(S::NAME);
        // A pool may have words to spare, in which an item is compared with the one that it replaces.
        assert!(used.words <= lent.words, "{}: {} words", S::NAME, used.words);
        let expected = PictureCapacities {
            words: used.words,
            damage_areas: 0,
            ..lent
        };
        assert_eq!(used, expected, "{}", S::NAME);
    }
}

#[test]
fn pictures_lend_what_their_frames_take() {
    let mut pictures = Pictures::default();
    visit(None, &mut pictures);
    assert_eq!(pictures.0, ["cockpit", "dashboard", "instruments", "oled"]);
}
