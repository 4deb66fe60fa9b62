//! The weather picture of the dashboard: a sun behind a cloud, with smooth edges.

use std::f64::consts::TAU;

/// Columns and rows of the picture.
const SIZE: u32 = 48;
/// Samples of a pixel in each direction.
const SAMPLES: u32 = 4;

type Color = [f64; 3];

/// What the dashboard's card has behind the picture.
const CARD: Color = [24.0, 32.0, 48.0];
const SUN: Color = [255.0, 196.0, 40.0];
const CLOUD: Color = [232.0, 240.0, 248.0];
const SHADOW: Color = [150.0, 172.0, 200.0];

/// The picture, row by row, big-endian RGB565.
pub fn weather() -> Vec<u8> {
    let mut bytes = Vec::new();
    for y in 0..SIZE {
        for x in 0..SIZE {
            bytes.extend(rgb565(pixel(x, y)).to_be_bytes());
        }
    }
    bytes
}

fn pixel(x: u32, y: u32) -> Color {
    let mut sum = [0.0; 3];
    for sample in 0..SAMPLES * SAMPLES {
        let offset = |step: u32| (f64::from(step) + 0.5) / f64::from(SAMPLES);
        let color = color_at(
            f64::from(x) + offset(sample % SAMPLES),
            f64::from(y) + offset(sample / SAMPLES),
        );
        sum = [0, 1, 2].map(|channel| sum[channel] + color[channel]);
    }
    sum.map(|channel| channel / f64::from(SAMPLES * SAMPLES))
}

fn color_at(x: f64, y: f64) -> Color {
    if in_cloud(x, y) {
        // What lies below the same cloud moved up is its dark underside.
        return if in_cloud(x, y + 5.0) { CLOUD } else { SHADOW };
    }
    if in_sun(x, y) { SUN } else { CARD }
}

fn in_sun(x: f64, y: f64) -> bool {
    let (x, y) = (x - 18.0, y - 18.0);
    let distance = x.hypot(y);
    let turn = (y.atan2(x) / TAU * 12.0).rem_euclid(1.0);
    // A disc, and around it twelve rays.
    let ray = (turn - 0.5).abs() * TAU / 12.0 * distance < 1.2;
    distance < 9.0 || (11.5..16.0).contains(&distance) && ray
}

fn in_cloud(x: f64, y: f64) -> bool {
    let puffs = [(20.0, 34.0, 7.5), (29.0, 28.0, 10.0), (38.5, 34.5, 7.0)];
    let in_puff = |&(center_x, center_y, radius): &(f64, f64, f64)| (x - center_x).hypot(y - center_y) < radius;
    puffs.iter().any(in_puff) || (20.0..38.5).contains(&x) && (32.0..41.5).contains(&y)
}

fn rgb565([red, green, blue]: Color) -> u16 {
    let scaled = |channel: f64, most: f64| (channel / 255.0 * most).round() as u16;
    scaled(red, 31.0) << 11 | scaled(green, 63.0) << 5 | scaled(blue, 31.0)
}
