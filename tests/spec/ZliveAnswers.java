import java.nio.file.Path;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import net.sourceforge.czt.animation.eval.UndefException;
import net.sourceforge.czt.animation.eval.ZLive;
import net.sourceforge.czt.session.FileSource;
import net.sourceforge.czt.session.Key;
import net.sourceforge.czt.session.SectionManager;
import net.sourceforge.czt.session.Source;
import net.sourceforge.czt.z.ast.ConjPara;
import net.sourceforge.czt.z.ast.FalsePred;
import net.sourceforge.czt.z.ast.Para;
import net.sourceforge.czt.z.ast.Pred;
import net.sourceforge.czt.z.ast.Sect;
import net.sourceforge.czt.z.ast.Spec;
import net.sourceforge.czt.z.ast.TruePred;
import net.sourceforge.czt.z.ast.ZSect;
import net.sourceforge.czt.z.util.ZUtils;

/**
 * Has ZLive decide the conjectures of Z files: `java -cp CZT_JAR ZliveAnswers.java FILE...` (zlive.py calls it). One line a
 * conjecture, in the order of the text: `ANSWER FILE true`, `false`, `undefined`, `open` and why, or `ANSWER FILE refused` and
 * why, once, for a text that is not read.
 */
public final class ZliveAnswers {
  private static final int SECONDS = 20; // for one conjecture

  private static String answer(ZLive zlive, Pred claim) throws InterruptedException {
    ExecutorService one = Executors.newSingleThreadExecutor(task -> {
      Thread thread = new Thread(null, task, "claim", 256L << 20);
      thread.setDaemon(true);
      return thread;
    });
    Future<Pred> result = one.submit(() -> zlive.evalPred(claim));
    try {
      Pred value = result.get(SECONDS, TimeUnit.SECONDS);
      return value instanceof TruePred ? "true" : value instanceof FalsePred ? "false" : "open " + value;
    } catch (TimeoutException late) {
      result.cancel(true);
      return "open late";
    } catch (ExecutionException refusal) {
      Throwable cause = refusal.getCause();
      return cause instanceof UndefException ? "undefined" : "open " + cause.toString().replaceAll("\\s+", " ");
    } finally {
      one.shutdownNow();
    }
  }

  private static void file(String file) throws InterruptedException {
    ZLive zlive = new ZLive();
    Spec spec;
    try {
      SectionManager manager = zlive.getSectionManager();
      manager.put(new Key<>(file, Source.class), new FileSource(Path.of(file).toString()));
      spec = manager.get(new Key<>(file, Spec.class));
      for (Sect section : spec.getSect())
        if (section instanceof ZSect) zlive.setCurrentSection(((ZSect) section).getName());
    } catch (Exception refusal) {
      System.out.println("ANSWER " + file + " refused " + refusal.toString().replaceAll("\\s+", " "));
      return;
    }
    for (Sect section : spec.getSect()) {
      if (!(section instanceof ZSect)) continue;
      for (Para paragraph : ZUtils.assertZParaList(((ZSect) section).getParaList()))
        if (paragraph instanceof ConjPara)
          System.out.println("ANSWER " + file + " " + answer(zlive, ((ConjPara) paragraph).getPred()));
    }
  }

  public static void main(String[] files) throws InterruptedException {
    for (String file : files) file(file);
  }
}
