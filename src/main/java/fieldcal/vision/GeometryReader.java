package fieldcal.vision;

import com.google.protobuf.CodedInputStream;
import fieldcal.camera.CameraCalibration;
import fieldcal.proto.SSL_FieldCircularArc;
import fieldcal.proto.SSL_FieldLineSegment;
import fieldcal.proto.SSL_GeometryCameraCalibration;
import fieldcal.proto.SSL_GeometryData;
import fieldcal.proto.SSL_GeometryFieldSize;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Predicate;
import java.util.stream.DoubleStream;

/** Decodes the geometry message; parts that are incomplete or impossible are left out and counted. */
final class GeometryReader {
  private static final double MM_PER_M = 1000.0;

  private GeometryReader() {}

  static Optional<FieldGeometry> read(CodedInputStream in, DecodingCounts counts)
      throws IOException {
    // Not parseFrom: a missing required field costs only the part that lacks it, not the whole
    // packet.
    SSL_GeometryData message = SSL_GeometryData.newBuilder().mergeFrom(in).buildPartial();
    in.checkLastTagWas(0);
    SSL_GeometryFieldSize field = message.getField();
    if (field.getFieldLength() <= 0
        || field.getFieldWidth() <= 0
        || field.getGoalWidth() < 0
        || field.getGoalDepth() < 0
        || field.getBoundaryWidth() < 0) {
      counts.add(DecodingProblem.BAD_FIELD_SIZE);
      return Optional.empty();
    }
    BallModels models = BallModels.of(message.getModels(), counts);
    return Optional.of(
        new FieldGeometry(
            field.getFieldLength() / MM_PER_M,
            field.getFieldWidth() / MM_PER_M,
            field.getGoalWidth() / MM_PER_M,
            field.getGoalDepth() / MM_PER_M,
            field.getBoundaryWidth() / MM_PER_M,
            lines(field, counts),
            arcs(field, counts),
            cameras(message, counts),
            models.flat(),
            models.chip()));
  }

  private static List<FieldLine> lines(SSL_GeometryFieldSize field, DecodingCounts counts) {
    Predicate<SSL_FieldLineSegment> usable =
        line ->
            line.isInitialized()
                && areFinite(
                    line.getP1().getX(),
                    line.getP1().getY(),
                    line.getP2().getX(),
                    line.getP2().getY(),
                    line.getThickness());
    return usable(field.getFieldLinesList(), usable, DecodingProblem.BAD_FIELD_LINE, counts)
        .stream()
        .map(
            line ->
                new FieldLine(
                    line.getName(),
                    line.getP1().getX() / MM_PER_M,
                    line.getP1().getY() / MM_PER_M,
                    line.getP2().getX() / MM_PER_M,
                    line.getP2().getY() / MM_PER_M,
                    line.getThickness() / MM_PER_M))
        .toList();
  }

  private static List<FieldArc> arcs(SSL_GeometryFieldSize field, DecodingCounts counts) {
    Predicate<SSL_FieldCircularArc> usable =
        arc ->
            arc.isInitialized()
                && areFinite(
                    arc.getCenter().getX(),
                    arc.getCenter().getY(),
                    arc.getRadius(),
                    arc.getA1(),
                    arc.getA2(),
                    arc.getThickness());
    return usable(field.getFieldArcsList(), usable, DecodingProblem.BAD_FIELD_LINE, counts).stream()
        .map(
            arc ->
                new FieldArc(
                    arc.getName(),
                    arc.getCenter().getX() / MM_PER_M,
                    arc.getCenter().getY() / MM_PER_M,
                    arc.getRadius() / MM_PER_M,
                    arc.getA1(),
                    arc.getA2(),
                    arc.getThickness() / MM_PER_M))
        .toList();
  }

  private static List<CameraCalibration> cameras(SSL_GeometryData message, DecodingCounts counts) {
    List<CameraCalibration> cameras = new ArrayList<>();
    for (SSL_GeometryCameraCalibration calibration : message.getCalibList()) {
      int id = calibration.getCameraId();
      if (!calibration.isInitialized()
          || id < 0
          || id > VisionDecoder.MAX_CAMERA_ID
          || !isFinite(calibration)
          || cameras.stream().anyMatch(camera -> camera.id() == id)) {
        counts.add(DecodingProblem.BAD_CALIBRATION);
      } else {
        cameras.add(camera(calibration));
      }
    }
    return cameras;
  }

  private static CameraCalibration camera(SSL_GeometryCameraCalibration calibration) {
    boolean derived = hasDerivedPosition(calibration);
    return new CameraCalibration(
        calibration.getCameraId(),
        calibration.getFocalLength(),
        calibration.getPrincipalPointX(),
        calibration.getPrincipalPointY(),
        calibration.getDistortion(),
        calibration.getQ0(),
        calibration.getQ1(),
        calibration.getQ2(),
        calibration.getQ3(),
        calibration.getTx() / MM_PER_M,
        calibration.getTy() / MM_PER_M,
        calibration.getTz() / MM_PER_M,
        derived ? calibration.getDerivedCameraWorldTx() / MM_PER_M : Double.NaN,
        derived ? calibration.getDerivedCameraWorldTy() / MM_PER_M : Double.NaN,
        derived ? calibration.getDerivedCameraWorldTz() / MM_PER_M : Double.NaN,
        Math.max(calibration.getPixelImageWidth(), 0),
        Math.max(calibration.getPixelImageHeight(), 0));
  }

  private static boolean isFinite(SSL_GeometryCameraCalibration calibration) {
    return areFinite(
        calibration.getFocalLength(),
        calibration.getPrincipalPointX(),
        calibration.getPrincipalPointY(),
        calibration.getDistortion(),
        calibration.getQ0(),
        calibration.getQ1(),
        calibration.getQ2(),
        calibration.getQ3(),
        calibration.getTx(),
        calibration.getTy(),
        calibration.getTz());
  }

  private static boolean hasDerivedPosition(SSL_GeometryCameraCalibration calibration) {
    return calibration.hasDerivedCameraWorldTx()
        && calibration.hasDerivedCameraWorldTy()
        && calibration.hasDerivedCameraWorldTz()
        && areFinite(
            calibration.getDerivedCameraWorldTx(),
            calibration.getDerivedCameraWorldTy(),
            calibration.getDerivedCameraWorldTz());
  }

  private static <T> List<T> usable(
      List<T> all, Predicate<T> usable, DecodingProblem problem, DecodingCounts counts) {
    List<T> good = all.stream().filter(usable).toList();
    for (int bad = good.size(); bad < all.size(); bad++) {
      counts.add(problem);
    }
    return good;
  }

  private static boolean areFinite(double... values) {
    return DoubleStream.of(values).allMatch(Double::isFinite);
  }
}
