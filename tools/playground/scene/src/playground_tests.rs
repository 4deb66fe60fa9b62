//! Items against the library's own ways to draw them, and the picture in bands of all heights.

extern crate std;

use core::convert::Infallible;
use std::{boxed::Box, format, string::String, vec, vec::Vec};

use embedded_graphics::{
    pixelcolor::{Rgb565, Rgb888},
    prelude::*,
};
use zrow::{
    band::{Band, LittleEndian},
    draw::{DrawAntialiased, DrawOn, FillRule, Polygon, PrimitiveStyle, SubEllipse, SubLine},
    fixed::types::U24F8,
    geometry::{Sub8, SubPoint},
};

use crate::{AREA, BACKGROUND, HEIGHT, Method, PRESETS, Playground, WIDTH};

/// Draws a state of an RGB888 panel.
fn drawn(playground: &mut Playground, address: &str) -> Vec<u32> {
    playground.prepare(address).unwrap();
    let mut words = Vec::new();
    playground
        .draw::<Rgb888, _>(|band: Band<'_, Rgb888, LittleEndian>| {
            words.extend_from_slice(band.words());
            Ok::<_, Infallible>(())
        })
        .unwrap();
    words
}

/// The picture on which `draw` has drawn.
fn expected(draw: impl FnOnce(&mut Band<'_, Rgb888>)) -> Vec<u32> {
    let mut words = vec![0; WIDTH * HEIGHT];
    let mut band = Band::<Rgb888>::new(AREA, &mut words).unwrap();
    band.fill(BACKGROUND);
    draw(&mut band);
    words
}

fn at(x: f32, y: f32) -> SubPoint<Sub8> {
    SubPoint::from_units((x * 256.0) as i32, (y * 256.0) as i32).unwrap()
}

#[test]
fn antialiased_shapes_are_those_of_the_library() {
    let mut playground = Box::new(Playground::new());
    let address = "depth=rgb888&method=exact&precision=sub8&rows=3\
        &item=circle,ff8000,0,100.25:90.5;140.25:90.5&item=line,2040ff,7.5,20:200.25;215.5:160.75";
    let picture = expected(|band| {
        let mut cells = [0; WIDTH + 1];
        let disc = SubEllipse::circle(at(100.25, 90.5), U24F8::from_num(40)).unwrap();
        let line = SubLine::new(at(20.0, 200.25), at(215.5, 160.75), U24F8::from_num(7.5)).unwrap();
        let style = |color| PrimitiveStyle::with_fill(color).antialiased();
        let mut target = band.antialiased::<256, 256>(&mut cells);
        disc.into_styled(style(Rgb888::new(255, 128, 0)))
            .draw_on(&mut target)
            .unwrap();
        line.into_styled(style(Rgb888::new(32, 64, 255)))
            .draw_on(&mut target)
            .unwrap();
    });
    assert!(drawn(&mut playground, address) == picture);
}

/// A star that crosses itself takes the area inside, what does not cross itself the signed area, and a rectangle of whole pixels
/// centre samples.
#[test]
fn the_exact_method_is_the_one_of_the_library() {
    let mut playground = Box::new(Playground::new());
    for (item, method) in [
        (
            "polygon,ffffff,0,120:40;181.5:250.5;20.25:118.75;219.75:118.75;58.5:250.5",
            Method::InsideArea,
        ),
        ("polygon,ffffff,0,120:40;181.5:250.5;20.25:118.75", Method::SignedArea),
        ("circle,ffffff,0,100.25:90.5;140.25:90.5", Method::SignedArea),
        ("text,ffffff,34,22:246,42", Method::SignedArea),
        ("polygon,ffffff,0,9.5:9.5;29.5:9.5;29.5:19.5;9.5:19.5", Method::None),
    ] {
        playground.prepare(&format!("method=exact&item={item}")).unwrap();
        assert_eq!(playground.method_of(0), Some(method), "{item}");
    }
}

#[test]
fn polygons_without_antialiasing_are_those_of_the_library() {
    let star = [
        (120.0, 40.0),
        (181.5, 250.5),
        (20.25, 118.75),
        (219.75, 118.75),
        (58.5, 250.5),
    ];
    let mut playground = Box::new(Playground::new());
    for (kind, rule) in [("polygon", FillRule::NonZero), ("even_odd", FillRule::EvenOdd)] {
        let points: Vec<String> = star.iter().map(|(x, y)| format!("{x}:{y}")).collect();
        let address = format!(
            "depth=rgb888&method=none&precision=sub8&item={kind},00ff00,0,{}",
            points.join(";")
        );
        let picture = expected(|band| {
            let corners = star.map(|(x, y)| at(x, y));
            let contours = [corners.as_slice()];
            let polygon = Polygon::new(&contours, rule).prepare::<8, 8>().unwrap();
            let Ok(()) = polygon
                .into_styled(PrimitiveStyle::with_fill(Rgb888::GREEN))
                .draw_on(band);
        });
        assert!(drawn(&mut playground, &address) == picture, "{kind}");
    }
}

#[test]
fn positions_are_rounded_to_the_precision() {
    let mut playground = Box::new(Playground::new());
    for (precision, square) in [
        ("whole", "10:10;20:10;20:20;10:20"),
        ("sub4", "10.25:10.0625;20.25:10.0625;20.25:20.0625;10.25:20.0625"),
    ] {
        let address = |precision, points| format!("depth=rgb888&precision={precision}&item=polygon,ffffff,0,{points}");
        let rounded = drawn(
            &mut playground,
            &address(precision, "10.25:10.05;20.25:10.05;20.25:20.05;10.25:20.05"),
        );
        assert!(
            rounded == drawn(&mut playground, &address("sub8", square)),
            "{precision}"
        );
    }
}

#[test]
fn bands_of_all_heights_have_the_same_pixels() {
    let mut playground = Box::new(Playground::new());
    for preset in PRESETS {
        for method in Method::ALL {
            let address = |rows: u32| format!("{}&depth=rgb888&method={}&rows={rows}", preset.address, method.name());
            let whole = drawn(&mut playground, &address(0));
            for rows in [1, 2, 7, 16] {
                assert!(
                    drawn(&mut playground, &address(rows)) == whole,
                    "{}, {method:?}, {rows} rows",
                    preset.title
                );
            }
        }
    }
}

#[test]
fn a_mask_is_the_coverage_of_one_item() {
    let mut playground = Box::new(Playground::new());
    let address =
        "method=rooks_16&depth=rgb888&item=circle,ff0000,0,50:50;60:50&item=polygon,ffffff,0,10.5:10;90:30;40.25:77";
    playground.prepare(address).unwrap();
    let mut mask = Box::new([7; WIDTH * HEIGHT]);
    playground.cover(1, &mut mask);
    let alone = address.split("&item=circle,ff0000,0,50:50;60:50").collect::<String>();
    playground.prepare(&alone).unwrap();
    let mut levels = Box::new([0; WIDTH * HEIGHT]);
    playground.cover(0, &mut levels);
    assert!(mask == levels && mask.iter().any(|coverage| (1..255).contains(coverage)));
    // An item that is not there covers nothing.
    playground.cover(1, &mut mask);
    assert!(mask.iter().all(|coverage| *coverage == 0));
}

/// What is counted on the chips is what the page shows.
#[test]
fn drawing_directly_draws_the_same() {
    let mut playground = Box::new(Playground::new());
    for preset in PRESETS {
        for method in Method::ALL {
            let address = format!("{}&method={}&depth=rgb565", preset.address, method.name());
            playground.prepare(&address).unwrap();
            let [mut drawn, mut directly] = [const { Vec::<u16>::new() }; 2];
            let sink = |band: Band<'_, Rgb565, LittleEndian>| {
                drawn.extend_from_slice(band.words());
                Ok::<_, Infallible>(())
            };
            playground.draw::<Rgb565, _>(sink).unwrap();
            let mut sink = |band: Band<'_, Rgb565, LittleEndian>| {
                directly.extend_from_slice(band.words());
                Ok::<_, Infallible>(())
            };
            playground.draw_directly(&mut sink).unwrap();
            assert!(drawn == directly, "{}, {method:?}", preset.title);
        }
    }
}

#[test]
fn presets_are_read_whole() {
    let mut playground = Box::new(Playground::new());
    for preset in PRESETS {
        playground.prepare(preset.address).unwrap();
        let items = preset.address.matches("&item=").count();
        assert_eq!(playground.state().items.len(), items, "{}", preset.title);
        assert_eq!(preset.counts.len(), items, "{}", preset.title);
    }
}

#[test]
fn a_row_of_rgb565_takes_480_bytes() {
    let mut playground = Box::new(Playground::new());
    playground
        .prepare("pot=flat&rows=1&depth=rgb565&method=inside_area")
        .unwrap();
    let footprint = playground.footprint();
    assert_eq!(
        (footprint.band, footprint.depth_row, footprint.coverage_row),
        (480, 480, 0)
    );
    assert_eq!((footprint.frame_buffer, footprint.depth_buffer), (153_600, 153_600));
    playground
        .prepare("pot=none&rows=4&depth=rgb888&method=inside_area&item=line,ffffff,1,0:0;9:9")
        .unwrap();
    let footprint = playground.footprint();
    assert_eq!(
        (footprint.band, footprint.depth_row, footprint.coverage_row),
        (3840, 0, 964)
    );
    assert_eq!((footprint.frame_buffer, footprint.depth_buffer), (230_400, 0));
}
