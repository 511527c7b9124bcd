package fieldcal.simulation.truth;

import fieldcal.camera.CameraCalibration;
import fieldcal.simulation.imaging.CameraErrors;

/**
 * A camera as it is and as it is published.
 *
 * @param trueCalibration as it is
 * @param publishedCalibration as vision believes it to be
 * @param errors what is wrong with it
 * @param rate frames per second
 * @param frames frames that reached the recording
 */
public record CameraTruth(
    CameraCalibration trueCalibration,
    CameraCalibration publishedCalibration,
    CameraErrors errors,
    double rate,
    long frames) {}
