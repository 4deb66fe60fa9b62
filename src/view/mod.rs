//! From model to world to eye to screen: transforms and the camera.
