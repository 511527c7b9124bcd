package fieldcal.fit.joint;

import fieldcal.ball.Parameter;
import java.util.List;

/** The toy of these tests keeps the contract, and the contract's default for shared columns works. */
class ToyKickTest extends KickTermContract<double[]> {
  @Override
  protected List<Case<double[]>> cases() {
    ToyKick kick =
        new ToyKick(
            new double[] {1, 2, 3},
            new double[][] {{1, 1, 1}, {0, 1, 2}},
            new double[][] {{0.5, -1, 2}});
    List<Parameter> globals = List.of(ToyProblem.parameter("g", 0.3, 1));
    return List.of(
        new Case<>(
            "toy",
            kick,
            new double[] {0.2, -0.4},
            new double[] {1, 1},
            double[]::clone,
            globals,
            1e-7));
  }
}
