use crate::{HomingMark, PlaceMark};

/// What a thing in the picture is; the theme decides what it looks like.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Role {
    /// The floor of a room.
    Room,
    /// The name of a room.
    RoomLabel,
    /// A wall of the world.
    Wall,
    /// A box or a post that stands in the world.
    Furniture,
    /// A door leaf as it stands.
    Door,
    /// The way that a door leaf swings.
    DoorSwing,
    /// Somebody who walks there.
    Person,
    /// Where the robot really went.
    TruePath,
    /// The robot where it really is.
    Robot,
    /// What the laser swept.
    LaserFan,
    /// A point that the laser hit.
    LaserHit,
    /// The world's walls laid over a memory.
    Truth,
    /// A surface of the map, by the number of the view that first saw it.
    SurfaceOfView(usize),
    /// The same for surfaces too short to say much.
    DebrisOfView(usize),
    /// The same two by how long ago that was: so many doublings of the number of views since.
    SurfaceOfAge(u32),
    /// See there.
    DebrisOfAge(u32),
    /// A mark of the network of local spaces.
    Place(PlaceMark),
    /// A mark of the way home.
    Homing(HomingMark),
    /// A surface of the latest view, where it lies in the map.
    SeenNow,
    /// The surface of the map that the latest view was placed by.
    ReferenceKnown,
    /// The surface of the latest view that was recognised as it.
    ReferenceSeen,
    /// Where the robot believes that it went.
    Path,
    /// A place at which it took a view.
    PathStep,
    /// A view that was placed by a reference with a guess in it.
    WeakPlacement,
    /// A view that was placed by odometry.
    FallbackPlacement,
    /// The robot where it believes that it is.
    BelievedRobot,
    /// What a figure adds to explain the rest.
    Annotation(crate::Annotation),
}
