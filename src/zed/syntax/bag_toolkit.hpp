#pragma once
/// The bags of Spivey's Z, which ISO Z has not (The Z Notation, 4.6), as a section of Z.

#include <array>
#include <string_view>

namespace durero::zed {

inline constexpr std::string_view bag_toolkit = "bag_toolkit";

/// The names that it declares.
inline constexpr std::array<std::string_view, 10> bag_names = {"bag _", "_ ♯ _", "count", "items", "⟦ ,, ⟧",
                                                               "_ ⋿ _", "_ ⊑ _", "_ ⊎ _", "_ ⩁ _", "_ ⊗ _"};

/// A text that uses bags has this section among its parents.
inline constexpr std::string_view bag_toolkit_text = R"(
─ section bag_toolkit parents standard_toolkit └
─ generic (bag _) └
─ function 30 leftassoc (_ ⊎ _) └
─ function 30 leftassoc (_ ⩁ _) └
─ function 40 leftassoc (_ ⊗ _) └
─ function 50 leftassoc (_ ♯ _) └
─ relation (_ ⋿ _) └
─ relation (_ ⊑ _) └
─ function (⟦ ,, ⟧) └
A bag says of each member how often it is in it.
─ bag X == X ⇸ ℕ₁ └
╷═ [X]
  _ ♯ _ : bag X × X → ℕ;
  count : bag X → X → ℕ;
  items : seq X → bag X;
  ⟦ ,, ⟧ : seq X → bag X;
  _ ⋿ _ : X ↔ bag X;
  _ ⊑ _ : bag X ↔ bag X;
  _ ⊎ _, _ ⩁ _ : bag X × bag X → bag X;
  _ ⊗ _ : ℕ × bag X → bag X
├
  ∀ b : bag X; x : X • b ♯ x = (if x ∈ dom b then b x else 0)
  ∀ b : bag X; x : X • count b x = b ♯ x
  ∀ s : seq X • items s = {x : ran s • x ↦ # (s ▷ {x})}
  ∀ s : seq X • (⟦ ,, ⟧) s = items s
  ∀ x : X; b : bag X • x ⋿ b ⇔ x ∈ dom b
  ∀ b, c : bag X • b ⊑ c ⇔ (∀ x : dom b • b x ≤ c ♯ x)
  ∀ b, c : bag X • b ⊎ c = {x : dom b ∪ dom c • x ↦ b ♯ x + c ♯ x}
  ∀ b, c : bag X • b ⩁ c = {x : dom b | b x > c ♯ x • x ↦ b x - c ♯ x}
  ∀ n : ℕ; b : bag X • n ⊗ b = {x : dom b | n > 0 • x ↦ n * b x}
└
)";

}  // namespace durero::zed
