/**
 * Cameras above the field: from the world into the image and back.
 *
 * <p>{@link fieldcal.camera.CameraCalibration} is one camera as a geometry packet describes it, {@link fieldcal.camera.Camera} is the
 * projection that follows from it: world to pixel, pixel to a plane at any height, and the projection of a flying ball onto the
 * ground, which is what vision reports. Everything is in metres and radians in the world frame (origin at the field centre, x to the
 * goal, y left, z up); only image coordinates are pixels.
 *
 * <p>Used by the packages that read vision, find kicks, fit them and simulate them; depends on nothing.
 */
@PublicApi
package fieldcal.camera;

import fieldcal.PublicApi;
