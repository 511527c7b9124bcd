/**
 * What the cameras report, in SI units: frames with ball and robot detections, the field's geometry, and the adapter
 * between these values and the league's protobuf messages.
 *
 * <p>Everything is a value, made once where its data becomes known: {@link fieldcal.vision.VisionFrame} is one image of one
 * camera, {@link fieldcal.vision.RobotId} names a robot, {@link fieldcal.vision.Epoch} ties the recording's seconds to Unix
 * time. This is the only package in which millimetres become metres.
 *
 * <p>Used by all packages that work with frames or the field's geometry, first of all {@code gamelog}, {@code kick}, {@code movement}, {@code play} and {@code simulation}.
 */
@PublicApi
package fieldcal.vision;

import fieldcal.PublicApi;
