//! Limits on the size of a domain's numbers.

use std::ops::RangeInclusive;

/// The greatest magnitude of a coordinate: areas, which are products of two, stay finite.
pub const GREATEST_COORDINATE: f64 = 1e100;

/// The shortest side: areas do not vanish.
pub const LEAST_SIDE: f64 = 1e-100;

/// The magnitudes of coordinates, besides 0, for which products of four are exact in the predicates that
/// check a domain that is not convex.
pub const EXACT_COORDINATES: RangeInclusive<f64> =
    1.793_662_034_335_766e-43..=3.213_876_088_517_980_6e60;

/// The shortest interval of a side, as a share of the side's length.
///
/// Parameters are off by less than `1e-14`, a hundredth of this: so they increase strictly
/// wherever no interval is shorter.
pub const LEAST_SHARE: f64 = 1e-12;

/// The greatest external degree of one entry of [`Constraints`](crate::Constraints). The two sides
/// at a corner and its own entry give at most three times as much, which fits in a u32.
pub const GREATEST_EXTERNAL_DEGREE: u32 = 1_000_000_000;

/// The most boundary vertices of a domain whose points are stored one by one: one with holes, with
/// reflex corners, or with sides that are not straight. Checking them takes some 60 bytes each.
pub const MAX_STORED_VERTICES: u32 = 1 << 26;

/// A side is straight if all its points are within this share of its length from the line between its
/// corners.
pub(crate) const STRAIGHT: f64 = 1e-9;

/// The minimum distance of two points, in roundings of a coordinate. Each point is off by less than
/// two, and so is the difference of corners its side is made from.
pub(crate) const LEAST_ROUNDINGS: f64 = 8.0;
