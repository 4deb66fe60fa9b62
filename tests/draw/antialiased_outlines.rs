//! Antialiased outlines in pictures: the same as polygons drawn without a picture, in bands of any height and order; boxes
//! that are tight; damage that leaves nothing out; memory of every size.

use embedded_graphics::{pixelcolor::Rgb565, prelude::*, primitives::Rectangle};
use proptest::prelude::*;
use zrow::{
    band::Band,
    coverage::InsideArea,
    draw::{
        AntialiasedPolygon, AntialiasingMemory, DrawAntialiased, DrawOn, FillRule, ItemId, Picture, PictureSlot,
        PrimitiveStyle, SubArc, SubEllipse, SubLine, SubOutline,
    },
    fixed::types::{U0F16, U24F8},
    geometry::{InputError, Sub8, SubPixel, SubPoint, TooSmall, Window},
};

use crate::{
    common::{self, cases, config},
    picture_display::{self, Display},
};

const AREA: Rectangle = Rectangle::new(Point::zero(), Size::new(50, 40));
const WIDTH: usize = 50;

type Polygon = AntialiasedPolygon<512, 512>;

/// An outline, its fill rule and its colour.
type Shape = (Contours, FillRule, Rgb565);

/// Contours of corners, or a curve.
#[derive(Debug, Clone)]
enum Contours {
    Corners(Vec<Vec<SubPoint<Sub8>>>),
    Ellipse(SubEllipse),
    Arc(SubArc),
    Line(SubLine),
}

impl SubOutline for Contours {
    fn edges(&self, edge: &mut dyn FnMut([i32; 2], [i32; 2])) {
        match self {
            Self::Corners(contours) => {
                let contours: Vec<&[SubPoint<Sub8>]> = contours.iter().map(Vec::as_slice).collect();
                contours.as_slice().edges(edge);
            }
            Self::Ellipse(ellipse) => ellipse.edges(edge),
            Self::Arc(arc) => arc.edges(edge),
            Self::Line(line) => line.edges(edge),
        }
    }

    fn is_simple(&self) -> bool {
        !matches!(self, Self::Corners(_))
    }
}

fn point((x, y): (i32, i32)) -> SubPoint<Sub8> {
    SubPoint::from_units(x, y).unwrap()
}

/// Units from `-10` pixels to `end`: some on the boundaries of pixels, where boxes and rows begin and end.
fn units(end: i32) -> impl Strategy<Value = i32> {
    prop_oneof![3 => -10 * 256..end * 256, 2 => (-10..end).prop_map(|x| x * 256 + 128)]
}

fn corners() -> impl Strategy<Value = Vec<SubPoint<Sub8>>> {
    let far = || prop_oneof![9 => units(60), 1 => -600_000..600_000i32];
    let anywhere = prop::collection::vec((far(), far()).prop_map(point), 3..12);
    // Many corners in one row.
    let flat = prop::collection::vec((units(60), 1_000..1_400i32).prop_map(point), 3..12);
    prop_oneof![3 => anywhere, 1 => flat]
}

fn contours() -> impl Strategy<Value = Contours> {
    // Ordinary ones, some that are hardly longer than rounding, and some much longer than the picture.
    let length = || prop_oneof![8 => 0..9_000u32, 1 => 0..300u32, 1 => 0..60_000u32].prop_map(U24F8::from_bits);
    let angle = || any::<u16>().prop_map(U0F16::from_bits);
    let center = || (units(60), units(50)).prop_map(point);
    prop_oneof![
        4 => prop::collection::vec(corners(), 1..3).prop_map(Contours::Corners),
        1 => (center(), length(), length()).prop_map(|(center, across, down)| {
            Contours::Ellipse(SubEllipse::new(center, [across, down]).unwrap())
        }),
        1 => (center(), length(), length(), angle(), angle()).prop_map(|(center, one, other, start, sweep)| {
            Contours::Arc(SubArc::new(center, [one, other], start, sweep).unwrap())
        }),
        1 => (center(), center(), length()).prop_map(|(start, end, width)| {
            Contours::Line(SubLine::new(start, end, width).unwrap())
        }),
    ]
}

fn shapes() -> impl Strategy<Value = Shape> {
    let rules = prop_oneof![Just(FillRule::NonZero), Just(FillRule::EvenOdd)];
    let colors = (1..32u8, 0..64u8, 0..32u8).prop_map(|(red, green, blue)| Rgb565::new(red, green, blue));
    (contours(), rules, colors)
}

/// The words of an area after drawing.
fn words(area: Rectangle, draw: impl FnOnce(&mut Band<'_, Rgb565>)) -> Vec<u16> {
    let mut words = vec![0; (area.size.width * area.size.height) as usize];
    draw(&mut Band::new(area, &mut words).unwrap());
    words
}

/// The words of an area on which shapes were drawn one after the other without a picture: ellipses as styled shapes, and all
/// others as polygons, by the method that is picked for each.
fn drawn<'s>(area: Rectangle, shapes: impl IntoIterator<Item = &'s Shape>) -> Vec<u16> {
    words(area, |band| {
        let Ok(()) = background().draw_on(band);
        for (outline, fill_rule, color) in shapes {
            if let Contours::Ellipse(ellipse) = outline {
                // The right half of some is the mirror image of the left half, which a polygon does not know.
                let styled = ellipse.into_styled(PrimitiveStyle::with_fill(*color).antialiased());
                styled
                    .draw_on(&mut band.antialiased::<512, 512>(&mut [0; 100]))
                    .unwrap();
                continue;
            }
            let polygon = Polygon::prepare(outline, *fill_rule).unwrap();
            let method = polygon.exact_method(outline);
            polygon.draw(&method, *color, band, &mut [0; 100]).unwrap();
        }
    })
}

fn background() -> impl DrawOn<Color = Rgb565> {
    AREA.into_styled(PrimitiveStyle::with_fill(Rgb565::CSS_DARK_GREEN))
}

fn add(picture: &mut Picture<'_, '_, Rgb565>, (contours, fill_rule, color): &Shape) -> Result<ItemId, InputError> {
    picture.add_outline(shape_of(contours), *fill_rule, *color)
}

fn replace(
    picture: &mut Picture<'_, '_, Rgb565>,
    id: ItemId,
    (contours, fill_rule, color): &Shape,
) -> Result<(), InputError> {
    picture.replace_outline(id, shape_of(contours), *fill_rule, *color)
}

/// The shape itself, which says more of itself than its edges.
fn shape_of(contours: &Contours) -> &dyn SubOutline {
    match contours {
        Contours::Corners(_) => contours,
        Contours::Ellipse(ellipse) => ellipse,
        Contours::Arc(arc) => arc,
        Contours::Line(line) => line,
    }
}

/// Shapes that have much in common: contours of which corners move, come or go; arcs that grow and shrink at their ends;
/// and what is the same.
fn variations() -> impl Strategy<Value = Vec<Shape>> {
    let edits = prop::collection::vec((any::<usize>(), (units(60), units(60)), 0..4), 1..8);
    let corners = (corners(), edits).prop_map(|(mut corners, edits)| {
        let mut all = vec![Contours::Corners(vec![corners.clone()])];
        for (number, position, edit) in edits {
            let number = number % corners.len();
            match edit {
                0 => corners.insert(number, point(position)),
                1 if corners.len() > 3 => drop(corners.remove(number)),
                2 => {}
                _ => corners[number] = point(position),
            }
            all.push(Contours::Corners(vec![corners.clone()]));
        }
        all
    });
    let length = || (300..9_000u32).prop_map(U24F8::from_bits);
    let center = (units(60), units(50)).prop_map(point);
    let sweeps = prop::collection::vec(any::<u16>(), 2..8);
    let arcs = (center, length(), length(), any::<u16>(), sweeps).prop_map(|(center, one, other, start, sweeps)| {
        let arc = |sweep| {
            let (start, sweep) = (U0F16::from_bits(start), U0F16::from_bits(sweep));
            Contours::Arc(SubArc::new(center, [one, other], start, sweep).unwrap())
        };
        let mut all: Vec<_> = sweeps.into_iter().map(arc).collect();
        all.push(Contours::Arc(SubArc::ring(center, [one, other]).unwrap()));
        all.push(arc(u16::MAX));
        all
    });
    prop_oneof![corners, arcs].prop_map(|all| {
        let shape = |contours| (contours, FillRule::EvenOdd, Rgb565::CSS_GOLD);
        all.into_iter().map(shape).collect()
    })
}

/// The words that some shapes take in a pool.
fn words_of<'s>(shapes: impl IntoIterator<Item = &'s Shape>) -> usize {
    let (mut slots, mut pool, mut memory) = (
        [PictureSlot::EMPTY; 9],
        [0; 6_000],
        AntialiasingMemory::<51, 512, 0>::new(),
    );
    let mut picture = Picture::new(AREA, &mut slots, &mut pool, &mut []).with_antialiasing(&mut memory);
    for shape in shapes {
        add(&mut picture, shape).unwrap();
    }
    picture.words_used()
}

/// Four words, and those of chains or of arcs.
#[test]
fn words_of_outlines() {
    fn words(outline: &dyn SubOutline) -> usize {
        let (mut slots, mut pool) = ([PictureSlot::EMPTY; 1], [0; 200]);
        let mut memory = AntialiasingMemory::<51, 64, 0>::new();
        let mut picture: Picture<Rgb565> =
            Picture::new(AREA, &mut slots, &mut pool, &mut []).with_antialiasing(&mut memory);
        picture.add_outline(outline, FillRule::NonZero, Rgb565::RED).unwrap();
        picture.words_used()
    }
    let at = |x: i32, y: i32| point((x * 64, y * 64));
    // Up and down, two corners each: sides along pixels are level.
    let square = |side: i32| Contours::Corners(vec![vec![at(8, 8), at(8 + side, 8), at(8 + side, 99), at(8, 99)]]);
    assert_eq!(words(&square(90)), 4 + 2 * (1 + 2));
    assert_eq!(words(&square(90_000 / 64)), 5 + 2 * (2 + 4));
    // A sector of a band: an arc outside, one inside, and up to the top and down from it a chain each.
    let arc = |radius: [u32; 2]| {
        let radii = radius.map(|pixels| U24F8::from_num(pixels));
        SubArc::new(at(81, 82), radii, U0F16::ZERO, U0F16::from_num(0.2)).unwrap()
    };
    assert_eq!(words(&arc([60, 50])), 4 + 2 * 7 + 2 * 2);
}

proptest! {
    #![proptest_config(config(cases(250, 2_000)))]

    /// All that has coverage is in the box, and the box has nothing to spare but for corners of pixels that an edge
    /// passes.
    #[test]
    fn boxes_are_tight(corners in corners(), fill_rule in prop_oneof![Just(FillRule::NonZero), Just(FillRule::EvenOdd)]) {
        let polygon = Polygon::prepare(&[corners.as_slice()], fill_rule).unwrap();
        let bounds = polygon.bounds();
        let everywhere = Window { left: -20, top: -20, right: 80, bottom: 80 };
        let mut cells = vec![0; 101];
        polygon.cover::<_, TooSmall>(&InsideArea, &everywhere, &mut cells, |span, coverage| {
            assert!(coverage == 0 || bounds.contains(Point::new(span.start, span.y)), "{span:?} of {bounds:?}");
            assert!(coverage == 0 || bounds.contains(Point::new(span.end - 1, span.y)), "{span:?} of {bounds:?}");
            Ok(())
        }).unwrap();
        // The box of the corners, in pixels around their centres.
        let sides = |units: fn(&SubPoint<Sub8>) -> i32| {
            let units = || corners.iter().map(units).map(|unit| unit + 128);
            (units().min().unwrap() >> 8, (units().max().unwrap() + 255) >> 8)
        };
        let (top, bottom) = sides(|point| point.y_units());
        if bounds != Window::EMPTY {
            let (left, right) = sides(|point| point.x_units());
            prop_assert!((bounds.top, bounds.bottom) == (top, bottom));
            prop_assert!(left <= bounds.left && bounds.right <= right, "{bounds:?} in {left} {right}");
        }
    }

    /// Outlines that find no room for their edges are begun anew in every row; bands that are wider than the row memory are
    /// drawn in strips; bands come in any order.
    #[test]
    fn bands_of_any_height_and_order_show_the_same(
        shapes in prop::collection::vec(shapes(), 1..6),
        bands in prop::collection::vec((0..40i32, 1..12u32, -3..40i32, 1..50u32), 1..12),
    ) {
        let expected = drawn(AREA, &shapes);
        let mut all = AntialiasingMemory::<51, 512, 64>::new();
        let mut few = AntialiasingMemory::<8, 512, 5>::new();
        let mut none = AntialiasingMemory::<2, 512, 0>::new();
        for number in 0..3 {
            let (mut slots, mut pool, mut buckets) = ([PictureSlot::EMPTY; 6], [0; 4_000], [0; 40]);
            let picture = Picture::new(AREA, &mut slots, &mut pool, &mut buckets);
            let mut picture = match number {
                0 => picture.with_antialiasing(&mut all),
                1 => picture.with_antialiasing(&mut few),
                _ => picture.with_antialiasing(&mut none),
            };
            for shape in &shapes {
                add(&mut picture, shape).unwrap();
            }
            let rows = (0..40).map(|y| (y, 1, 0, 50));
            for (top, height, left, width) in rows.chain(bands.iter().copied()) {
                let band = Rectangle::new(Point::new(left, top), Size::new(width, height)).intersection(&AREA);
                let found = words(band, |band| {
                    let Ok(()) = background().draw_on(band);
                    picture.draw(band);
                });
                let lines = found.chunks(band.size.width.max(1) as usize);
                for (y, line) in band.rows().zip(lines) {
                    let start = y as usize * WIDTH + band.top_left.x as usize;
                    prop_assert_eq!(line, &expected[start..start + line.len()], "memory {}, row {} of {:?}", number, y, band);
                }
            }
        }
    }

    #[test]
    fn pictures_show_what_is_drawn_without_them(
        before in prop::collection::vec(shapes(), 1..6),
        after in prop::collection::vec(shapes(), 1..6),
    ) {
        let (mut slots, mut pool) = ([PictureSlot::EMPTY; 8], [0; 6_000]);
        let (mut buckets, mut areas) = ([0; 40], [Window::EMPTY; 8]);
        let mut memory = AntialiasingMemory::<51, 512, 16>::new();
        let mut picture = Picture::new(AREA, &mut slots, &mut pool, &mut buckets)
            .with_antialiasing(&mut memory)
            .with_damage(&mut areas, (1, 1));
        picture.add(&AREA.into_styled(PrimitiveStyle::with_fill(Rgb565::CSS_DARK_GREEN))).unwrap();
        let mut shown = before.clone();
        let ids: Vec<_> = shown.iter().map(|shape| add(&mut picture, shape).unwrap()).collect();
        let mut display = Display::new(AREA);
        display.draw_damage(&mut picture, &[1]);
        prop_assert_eq!(&display.words, &drawn(AREA, &shown));
        for (number, shape) in after.iter().enumerate() {
            let index = number % ids.len();
            shown[index] = shape.clone();
            replace(&mut picture, ids[index], shape).unwrap();
            display.draw_damage(&mut picture, &[1]);
            prop_assert_eq!(&display.words, &drawn(AREA, &shown));
        }
    }

    /// What is drawn again is all that changes, where shapes have much in common. The pool has room to compare them, or not.
    #[test]
    fn what_differs_between_similar_shapes_is_drawn_again(
        behind in shapes(),
        variations in variations(),
        front in shapes(),
        has_room: bool,
    ) {
        let longest = variations.iter().map(|shape| words_of([shape])).max().unwrap();
        let needed = words_of([&behind, &front]) + longest;
        let (mut slots, mut pool) = ([PictureSlot::EMPTY; 4], vec![0; if has_room { 6_000 } else { needed }]);
        let (mut buckets, mut areas) = ([0; 40], [Window::EMPTY; 16]);
        let mut memory = AntialiasingMemory::<51, 512, 16>::new();
        let mut picture = Picture::new(AREA, &mut slots, &mut pool, &mut buckets)
            .with_antialiasing(&mut memory)
            .with_damage(&mut areas, (1, 1));
        picture.add(&AREA.into_styled(PrimitiveStyle::with_fill(Rgb565::CSS_DARK_GREEN))).unwrap();
        add(&mut picture, &behind).unwrap();
        let id = add(&mut picture, &variations[0]).unwrap();
        add(&mut picture, &front).unwrap();
        let mut display = Display::new(AREA);
        for shape in &variations {
            replace(&mut picture, id, shape).unwrap();
            display.draw_damage(&mut picture, &[1]);
            prop_assert_eq!(&display.words, &drawn(AREA, [&behind, shape, &front]));
        }
        // The same once more.
        replace(&mut picture, id, variations.last().unwrap()).unwrap();
        prop_assert!(!has_room || picture.next_damage().is_none());
    }

    /// From no memory on: each error says how much is needed of what, that much does, and the picture is usable after it.
    #[test]
    fn errors_say_how_much_is_needed(shape in shapes(), other in shapes()) {
        let mut needed = (0usize, 0usize);
        let mut tries = 0;
        let mut segments = [AntialiasingMemory::<51, 0, 0>::new()];
        loop {
            let (mut slots, mut pool, mut buckets) = ([PictureSlot::EMPTY; 1], vec![0; needed.0], [0; 40]);
            let mut enough = AntialiasingMemory::<51, 512, 8>::new();
            let picture = Picture::new(AREA, &mut slots, &mut pool, &mut buckets);
            let mut picture = if needed.1 == 0 {
                picture.with_antialiasing(&mut segments[0])
            } else {
                picture.with_antialiasing(&mut enough)
            };
            match add(&mut picture, &shape) {
                Ok(id) => {
                    prop_assert_eq!(picture.words_used(), needed.0);
                    let expected = drawn(AREA, [&shape]);
                    let show = |picture: &mut Picture<'_, '_, Rgb565>| words(AREA, |band| {
                        let Ok(()) = background().draw_on(band);
                        picture.draw(band);
                    });
                    prop_assert_eq!(&show(&mut picture), &expected);
                    // What finds no room leaves all as it was.
                    if replace(&mut picture, id, &other).is_err() {
                        prop_assert_eq!(&show(&mut picture), &expected);
                    } else {
                        prop_assert_eq!(&show(&mut picture), &drawn(AREA, [&other]));
                    }
                    break;
                }
                Err(InputError::TooSmall(TooSmall::PictureWords(words))) => {
                    prop_assert!(words > needed.0);
                    needed.0 = words;
                }
                Err(InputError::TooSmall(TooSmall::Segments(segments))) => {
                    prop_assert!(needed.1 == 0 && segments > 0 && segments <= 512);
                    needed.1 = segments;
                }
                Err(error) => prop_assert!(false, "{error}"),
            }
            prop_assert_eq!(picture.words_used(), 0);
            tries += 1;
            prop_assert!(tries < 4);
        }
    }
}

/// The contour has two chains, of which each has at most six edges in a row, and the edge that closes it counts by itself.
#[test]
fn a_disc_needs_few_segments() {
    let disc = SubEllipse::circle(point((5_000, 5_000)), U24F8::from_num(18)).unwrap();
    let mut memory = AntialiasingMemory::<51, 13, 2>::new();
    let (mut slots, mut pool) = ([PictureSlot::EMPTY; 1], [0; 100]);
    let mut picture = Picture::<Rgb565>::new(AREA, &mut slots, &mut pool, &mut []).with_antialiasing(&mut memory);
    picture.add_outline(&disc, FillRule::NonZero, Rgb565::RED).unwrap();
}

#[test]
fn outlines_beyond_the_domain_are_an_error() {
    struct Far;
    impl SubOutline for Far {
        fn edges(&self, edge: &mut dyn FnMut([i32; 2], [i32; 2])) {
            let corners = [[0, 0], [3_000_000, 100], [0, 200]];
            for (index, from) in corners.iter().enumerate() {
                edge(*from, corners[(index + 1) % 3]);
            }
        }
    }
    let mut memory = AntialiasingMemory::<51, 8, 2>::new();
    let (mut slots, mut pool) = ([PictureSlot::EMPTY; 1], [0; 30]);
    let mut picture = Picture::<Rgb565>::new(AREA, &mut slots, &mut pool, &mut []).with_antialiasing(&mut memory);
    let added = picture.add_outline(&Far, FillRule::NonZero, Rgb565::RED);
    assert!(matches!(added, Err(InputError::OutOfDomain { .. })), "{added:?}");
    assert_eq!((picture.slots_used(), picture.words_used()), (0, 0));
}

/// A point that is said to be near all corners may be anywhere: the picture is that of the corners.
#[test]
fn an_anchor_far_from_the_outline_changes_nothing() {
    struct Anchored(Contours, Option<[i32; 2]>);
    impl SubOutline for Anchored {
        fn edges(&self, edge: &mut dyn FnMut([i32; 2], [i32; 2])) {
            self.0.edges(edge);
        }

        fn anchor(&self) -> Option<[i32; 2]> {
            self.1
        }
    }
    let corners = [(300, 500), (9_000, 2_000), (4_000, 8_000)].map(point);
    let end = Sub8::MAX_UNITS;
    let anchors = [
        None,
        Some([0, 0]),
        Some([end, -end]),
        Some([end + 1, 0]),
        Some([i32::MIN, i32::MAX]),
        Some([5, i32::MIN]),
    ];
    let pictures = anchors.map(|anchor| {
        let outline = Anchored(Contours::Corners(vec![corners.to_vec()]), anchor);
        let mut memory = AntialiasingMemory::<51, 8, 2>::new();
        let (mut slots, mut pool) = ([PictureSlot::EMPTY; 1], [0; 30]);
        let mut picture = Picture::<Rgb565>::new(AREA, &mut slots, &mut pool, &mut []).with_antialiasing(&mut memory);
        picture.add_outline(&outline, FillRule::NonZero, Rgb565::RED).unwrap();
        common::picture(AREA, |band| picture.draw(band))
    });
    assert!(pictures.iter().all(|picture| *picture == pictures[0]));
    assert!(pictures[0].contains(&Rgb565::RED));
}

/// A triangle whose upright side is cut into edges of 1/256 pixel, which are more than one chain can have: its pixels are those of
/// the triangle with three corners.
#[test]
fn an_outline_may_go_down_in_more_edges_than_a_chain_has() {
    const END: i32 = 1 << 14;
    let area = Rectangle::new(Point::new(-2, -66), Size::new(8, 132));
    let triangle = [(1_000, 0), (0, -END), (0, END)].map(point).to_vec();
    let fine: Vec<_> = [(1_000, 0)]
        .into_iter()
        .chain((-END..=END).map(|y| (0, y)))
        .map(point)
        .collect();
    let shown = |corners: Vec<SubPoint<Sub8>>, height: u32| {
        let mut memory = AntialiasingMemory::<9, 300, 4>::new();
        let (mut slots, mut pool) = ([PictureSlot::EMPTY; 1], vec![0; 40_000]);
        let mut picture = Picture::<Rgb565>::new(area, &mut slots, &mut pool, &mut []).with_antialiasing(&mut memory);
        let contours = Contours::Corners(vec![corners]);
        picture.add_outline(&contours, FillRule::NonZero, Rgb565::RED).unwrap();
        picture_display::in_bands(&mut picture, area, &[height])
    };
    let expected = shown(triangle.clone(), 1);
    assert_eq!(expected, drawn_on_black(area, &Contours::Corners(vec![triangle])));
    assert!(expected.iter().filter(|word| **word != 0).count() > 250);
    for height in [1, 7] {
        assert_eq!(shown(fine.clone(), height), expected);
        // From the bottom to the top.
        assert_eq!(shown(fine.iter().rev().copied().collect(), height), expected);
    }
}

/// The words of an area on which a red outline was drawn without a picture.
fn drawn_on_black(area: Rectangle, outline: &Contours) -> Vec<u16> {
    let polygon = Polygon::prepare(outline, FillRule::NonZero).unwrap();
    words(area, |band| {
        let method = polygon.exact_method(outline);
        polygon.draw(&method, Rgb565::RED, band, &mut [0; 100]).unwrap();
    })
}

#[test]
fn without_memory_for_antialiasing_an_outline_is_an_error() {
    let line = SubLine::new(point((0, 0)), point((2_000, 2_000)), U24F8::from_num(3)).unwrap();
    let (mut slots, mut pool) = ([PictureSlot::EMPTY; 1], [0; 30]);
    let mut picture = Picture::<Rgb565>::new(AREA, &mut slots, &mut pool, &mut []);
    let added = picture.add_outline(&line, FillRule::NonZero, Rgb565::RED);
    let expected = TooSmall::PictureCells(2);
    assert_eq!(added, Err(InputError::TooSmall(expected)));
}
