//! Scenes of faces: projection, depths, clipping, bands in any order.

#[path = "../common/mod.rs"]
mod common;
#[path = "../reference"]
mod reference {
    pub mod nearest_faces;
}
#[path = "../common/snapped_faces.rs"]
mod snapped_faces;

mod affine_maps;
mod antialiased;
mod bounds;
mod byte_orders;
mod cameras;
mod clipped_faces;
mod coherence;
mod counters;
mod depth_polygons;
mod depth_row;
mod depth_state;
mod depth_state_shading;
mod depths_first;
mod double_sided;
mod estimates;
mod face_planes;
mod flight;
mod fog;
mod hidden_lines;
mod hidden_lines_appel;
mod hidden_lines_kept;
mod hidden_lines_roberts;
mod holes;
mod lighting;
mod morphing;
mod multisampled;
mod number_range;
mod numbered_scene;
mod orientations;
mod orthographic;
mod passes;
mod picture_items;
mod points_and_edges;
mod projection;
mod random_faces;
mod rotations;
mod same_looks;
mod scene;
mod shaded_scene;
mod shading_attributes;
mod shading_bands;
mod shading_lights;
mod shading_perspective;
mod shading_skins;
mod sky;
mod textures;
mod translucent;
mod unclipped_faces;
mod untested_rows;
mod visibility;
mod visibility_antialiased;
mod visibility_depth_sort;
mod visibility_looks;
mod visibility_rays;
mod visibility_scenes;
mod visibility_shading;
mod visibility_spans;
mod visibility_warnock;
mod visibility_work;
mod wireframes;
mod wireframes_in_depth;
