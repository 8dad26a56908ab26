package org.diacaustic.cli;

import java.util.ArrayList;
import java.util.List;
import org.diacaustic.study.Budget;
import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.TypeConversionException;

/** Reads budgets as they are written on the command line: numbers of light rays, or times with a unit. */
final class BudgetsConverter implements ITypeConverter<List<Budget>> {
    @Override
    public List<Budget> convert(String text) {
        List<Budget> budgets = new ArrayList<>();
        for (String word : text.split(",")) {
            Budget budget = budget(word.strip());
            if (budgets.contains(budget)) {
                throw new TypeConversionException("'" + word.strip() + "' is there twice");
            }
            budgets.add(budget);
        }
        return budgets;
    }

    private static Budget budget(String word) {
        if (word.matches("[0-9]{1,18}")) {
            long rays = Long.parseLong(word);
            if (rays == 0) {
                throw new TypeConversionException("a budget must be of at least 1 light ray, but is of 0");
            }
            return new Budget.Rays(rays);
        }
        try {
            return new Budget.Seconds(new TimeSpan.Converter().convert(word).seconds());
        } catch (TypeConversionException noTime) {
            throw new TypeConversionException(
                    "expected a number of light rays, such as 10000, or a time, such as 2s, found '" + word + "'");
        }
    }
}
