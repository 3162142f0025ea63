"""Record the clip that the chapters on stereo, odometry and mapping read."""
