//! Antialiasing: how much of a pixel a shape covers. Nothing here yet: shapes take a pixel or leave it.
