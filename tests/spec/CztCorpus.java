import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import net.sourceforge.czt.base.ast.Term;
import net.sourceforge.czt.parser.util.ErrorType;
import net.sourceforge.czt.parser.util.ParseException;
import net.sourceforge.czt.parser.z.ParseUtils;
import net.sourceforge.czt.session.Dialect;
import net.sourceforge.czt.session.FileSource;
import net.sourceforge.czt.session.SectionManager;
import net.sourceforge.czt.typecheck.z.ErrorAnn;
import net.sourceforge.czt.typecheck.z.TypeCheckUtils;
import net.sourceforge.czt.z.ast.SectTypeEnvAnn;

/**
 * Has CZT judge Z files, each by itself, in one JVM: `java -cp CZT_JAR CztCorpus.java FILE...` (corpus.sh calls it).
 * One line a file, in their order: `FILE accepted`, or `FILE refused` and what CZT says first.
 */
public final class CztCorpus {
  private static List<String> errors(String file) {
    SectionManager manager = new SectionManager(Dialect.Z);
    manager.putCommand(SectTypeEnvAnn.class, TypeCheckUtils.getCommand());
    manager.setProperty("czt.path", Path.of(file).toAbsolutePath().getParent().toString());
    List<String> found = new ArrayList<>();
    try {
      Term read = ParseUtils.parse(new FileSource(file), manager);
      for (ErrorAnn one : TypeCheckUtils.typecheck(read, manager))
        if (one.getErrorType() == ErrorType.ERROR) found.add(one.toString());
    } catch (ParseException refusal) {
      refusal.getErrorList().forEach(one -> found.add(one.toString()));
    } catch (Exception | StackOverflowError | OutOfMemoryError refusal) {
      found.add(refusal.toString());
    }
    return found;
  }

  public static void main(String[] files) {
    for (String file : files) {
      List<String> found = errors(file);
      System.out.println(
          file + (found.isEmpty() ? " accepted" : " refused " + found.get(0).replaceAll("\\s+", " ")));
    }
  }
}
