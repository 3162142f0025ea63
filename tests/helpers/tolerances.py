"""Every tolerance of the tests, with the reason for its size."""

#: Arithmetic in double precision on numbers of order one: rounding is 1e-16 a step.
EXACT = 1e-12

#: One float32 rounding: 24 bits of mantissa.
FLOAT32_RTOL = 2.0**-23

#: OpenGL keeps depth as float32 with reversed z; on flat geometry nothing else is lost.
DEPTH_MEDIAN_MM = 0.01

#: A cloud adds one float32 product and a rotation to that.
CLOUD_MEDIAN_MM = 0.1

#: MuJoCo draws curved geoms as polygons: off depth edges that is below a millimeter in this scene.
CLOUD_P99_MM = 2.0
