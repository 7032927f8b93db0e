//! The ROS 2 messages, as their packages define them.

/// Between a definition and those that it uses.
macro_rules! uses {
    ($name:literal) => {
        concat!(
            "================================================================================\n",
            "MSG: ",
            $name,
            "\n"
        )
    };
}

macro_rules! header {
    () => {
        concat!(
            uses!("std_msgs/Header"),
            "builtin_interfaces/Time stamp\nstring frame_id\n",
            uses!("builtin_interfaces/Time"),
            "int32 sec\nuint32 nanosec\n"
        )
    };
}

/// `sensor_msgs/msg/Imu`
pub const IMU: &str = concat!(
    "std_msgs/Header header\n",
    "geometry_msgs/Quaternion orientation\nfloat64[9] orientation_covariance\n",
    "geometry_msgs/Vector3 angular_velocity\nfloat64[9] angular_velocity_covariance\n",
    "geometry_msgs/Vector3 linear_acceleration\nfloat64[9] linear_acceleration_covariance\n",
    header!(),
    uses!("geometry_msgs/Quaternion"),
    "float64 x 0\nfloat64 y 0\nfloat64 z 0\nfloat64 w 1\n",
    uses!("geometry_msgs/Vector3"),
    "float64 x\nfloat64 y\nfloat64 z\n",
);

/// `sensor_msgs/msg/NavSatFix`
pub const FIX: &str = concat!(
    "uint8 COVARIANCE_TYPE_UNKNOWN=0\nuint8 COVARIANCE_TYPE_APPROXIMATED=1\n",
    "uint8 COVARIANCE_TYPE_DIAGONAL_KNOWN=2\nuint8 COVARIANCE_TYPE_KNOWN=3\n",
    "std_msgs/Header header\nsensor_msgs/NavSatStatus status\n",
    "float64 latitude\nfloat64 longitude\nfloat64 altitude\n",
    "float64[9] position_covariance\nuint8 position_covariance_type\n",
    header!(),
    uses!("sensor_msgs/NavSatStatus"),
    "int8 STATUS_NO_FIX=-1\nint8 STATUS_FIX=0\nint8 STATUS_SBAS_FIX=1\nint8 STATUS_GBAS_FIX=2\n",
    "int8 status\nuint16 SERVICE_GPS=1\nuint16 SERVICE_GLONASS=2\nuint16 SERVICE_COMPASS=4\n",
    "uint16 SERVICE_GALILEO=8\nuint16 service\n",
);

/// `geometry_msgs/msg/PoseStamped`
pub const POSE: &str = concat!(
    "std_msgs/Header header\ngeometry_msgs/Pose pose\n",
    header!(),
    uses!("geometry_msgs/Pose"),
    "geometry_msgs/Point position\ngeometry_msgs/Quaternion orientation\n",
    uses!("geometry_msgs/Point"),
    "float64 x\nfloat64 y\nfloat64 z\n",
    uses!("geometry_msgs/Quaternion"),
    "float64 x 0\nfloat64 y 0\nfloat64 z 0\nfloat64 w 1\n",
);
