//! The memory of a small scene in a look, and its picture.

use embedded_graphics::pixelcolor::{Rgb888, RgbColor};
use zrow::{
    band::Band,
    geometry::{InputError, SubPixel},
    scene::{FaceSet, Look, Memory, Prepared},
};

use crate::space::{
    input::{FACES, SPACE_SIZE, SpaceInput, VERTICES},
    shading::SpaceShading,
};

/// A corner on the screen: column and row, in pixels with centres at whole numbers, and the stored depth.
pub type ScreenCorner = [f64; 3];

/// Draws small scenes in one way.
pub trait SpaceRun {
    /// Bytes of the scene's memory, beside pixels.
    fn memory_bytes(&self) -> usize;

    /// Prepares a frame and nothing else.
    ///
    /// # Errors
    /// The scene does not fit the memory that the frame is prepared in.
    fn prepare(&mut self, input: &SpaceInput) -> Result<(), InputError>;

    /// Draws a frame and returns its words; 0 where nothing is. Where faces show numbers of their vertices, the first or the
    /// second one.
    ///
    /// # Errors
    /// The scene does not fit the memory that the frame is prepared in.
    fn draw(&mut self, input: &SpaceInput, shown: usize) -> Result<&[u32], InputError>;

    /// Hands over each face as it was snapped: its index and its corners.
    ///
    /// # Errors
    /// The scene does not fit the memory that the frame is prepared in.
    fn faces(&mut self, input: &SpaceInput, face: &mut dyn FnMut(usize, [ScreenCorner; 3])) -> Result<(), InputError>;
}

/// The memory of small scenes in a look, and a picture.
#[derive(Debug)]
pub struct SpaceStage<L: Look> {
    memory: Memory<L, VERTICES, FACES, SPACE_SIZE, SPACE_SIZE, FACES>,
    words: [u32; SPACE_SIZE * SPACE_SIZE],
}

impl<L: Look<Color = Rgb888, Shading: SpaceShading>> SpaceStage<L> {
    /// Nothing is drawn yet.
    pub const fn new() -> Self {
        Self {
            memory: Memory::new(),
            words: [0; SPACE_SIZE * SPACE_SIZE],
        }
    }

    /// The picture that was drawn last.
    pub const fn words(&self) -> &[u32] {
        &self.words
    }

    fn with_prepared<R>(
        &mut self,
        input: &SpaceInput,
        shown: usize,
        then: impl FnOnce(Prepared<'_, '_, L>, &mut [u32]) -> Result<R, InputError>,
    ) -> Result<R, InputError> {
        let mesh = FaceSet::new(&input.vertices, &input.faces)?;
        let models = [L::Shading::model(input, mesh, shown)?.with_pose(input.pose)];
        let prepared = self.memory.prepare(&input.camera()?, &models)?;
        then(prepared, &mut self.words)
    }
}

impl<L: Look<Color = Rgb888, Shading: SpaceShading>> Default for SpaceStage<L> {
    fn default() -> Self {
        Self::new()
    }
}

impl<L: Look<Color = Rgb888, Shading: SpaceShading>> SpaceRun for SpaceStage<L> {
    fn memory_bytes(&self) -> usize {
        size_of_val(&self.memory)
    }

    fn prepare(&mut self, input: &SpaceInput) -> Result<(), InputError> {
        self.with_prepared(input, 0, |prepared, _| {
            core::hint::black_box(&prepared);
            Ok(())
        })
    }

    fn draw(&mut self, input: &SpaceInput, shown: usize) -> Result<&[u32], InputError> {
        self.with_prepared(input, shown, |mut prepared, words| {
            let mut band = Band::<Rgb888>::new(SpaceInput::area(), words)?;
            band.fill(Rgb888::BLACK);
            prepared.draw(&mut band);
            Ok(())
        })?;
        Ok(&self.words)
    }

    fn faces(&mut self, input: &SpaceInput, face: &mut dyn FnMut(usize, [ScreenCorner; 3])) -> Result<(), InputError> {
        let pixel = f64::from(1 << L::Precision::FRACTION_BITS);
        self.with_prepared(input, 0, |prepared, _| {
            for screen_face in prepared.faces() {
                let corners = screen_face.corners.map(|corner| {
                    let [x, y] = [corner.point.x_units(), corner.point.y_units()].map(|units| f64::from(units) / pixel);
                    [x, y, f64::from(zrow::scene::DepthWidth::units(corner.depth))]
                });
                face(screen_face.order, corners);
            }
            Ok(())
        })
    }
}
