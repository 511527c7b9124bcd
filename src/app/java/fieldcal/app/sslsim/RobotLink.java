package fieldcal.app.sslsim;

import fieldcal.proto.RobotCommand;
import fieldcal.vision.Team;
import java.io.Closeable;
import java.io.IOException;
import java.util.List;
import java.util.Optional;

/** What commands go to: a simulator, or a bridge to real robots. Never waits for an answer. Not thread-safe. */
interface RobotLink extends Closeable {
  /** Tells robots of one team what to do. */
  void robots(Team team, List<RobotCommand> commands) throws IOException;

  /** Has the ball laid down at rest, where there is somebody who can. */
  void layBall(double x, double y) throws IOException;

  /** Reads what was answered since the last time. */
  void listen() throws IOException;

  /** Why no robot may drive now; empty when they may. */
  Optional<String> hold();

  /** Who does not answer now, for the operator; empty when all is well. */
  Optional<String> silent();

  /** For the operator at the end; empty when all is well. */
  List<String> notes();

  /** What the operator should hear of at once, each in the same words every time. */
  List<String> complaints();
}
