(** Sheets and cones: what spec/luz.tex claims of the light that clear elements let through, and of a light that shines
    into a cone. *)
From Coq Require Import Reals Lra Lia ZArith List Permutation Classical_Prop.
From Durero Require Import Toolkit Especificacion Tipos Puntos Iluminacion Power Luz.
Local Open Scope R_scope.
Local Open Scope zed_scope.

(** ** What stands before a light *)

(** Discharges ante.def.1, ante_lejos.def.1, ante.conj.1. *)
Theorem what_hides_a_light_stands_before_it (Elemento : Type) : ante_conj_1 Elemento.
Proof.
  intros s rayo en _ _. split; split.
  - intros [t [w [Ht [[e [He Hw]] [Lt Eq]]]]]. exists e, w. split; [exact He |]. split; [exact Hw |]. now exists t.
  - intros [e [w [He [Hw [t [Ht [Lt Eq]]]]]]]. exists t, w. split; [exact Ht |]. split; [now exists e | now split].
  - intros H. apply NNPP. intros No. apply H. intros w. split; [| easy].
    intros [e [He Hw]]. apply No. exists e, w. now split.
  - intros [e [w [He Hw]]] E. destruct (E w) as [F _]. apply F. exists e. now split.
Qed.

(** ** What they let through *)
Section Through.
Variable X : Type.
Implicit Types (l : list X) (share : rel X R).

(** The product of the shares of a list. *)
Fixpoint left_behind share l : set R := fun k =>
  match l with
  | nil => k = 1
  | a :: rest => exists u v, left_behind share rest u /\ (a, v) ∈ share /\ k = u * v
  end.

Lemma left_behind_one share l k j : functional share -> left_behind share l k -> left_behind share l j -> k = j.
Proof.
  intros F. revert k j. induction l as [| a l IH]; cbn; [congruence |].
  intros k j [u [v [Hu [Hv ->]]]] [u' [v' [Hu' [Hv' ->]]]]. now rewrite (IH _ _ Hu Hu'), (F _ _ _ Hv Hv').
Qed.

Lemma left_behind_in_any_order share l l' k : Permutation l l' -> left_behind share l k -> left_behind share l' k.
Proof.
  intros P. revert k. induction P as [| a l l' _ IH | a b l | l l' l'' _ IH _ IH']; intros k; cbn.
  - easy.
  - intros [u [v [Hu [Hv ->]]]]. exists u, v. repeat split; [now apply IH | exact Hv].
  - intros [u [v [[w [x [Hw [Hx ->]]]] [Hv ->]]]]. exists (w * v), x. split; [| split; [exact Hx | ring]].
    now exists w, v.
  - intros H. now apply IH', IH.
Qed.

Lemma left_behind_nothing share l a k : functional share -> In a l -> (a, 0) ∈ share -> left_behind share l k -> k = 0.
Proof.
  intros F. revert k. induction l as [| b l IH]; cbn; [easy |].
  intros k [-> | Ha] Hz [u [v [Hu [Hv ->]]]].
  - rewrite (F _ _ _ Hv Hz). ring.
  - rewrite (IH u Ha Hz Hu). ring.
Qed.

Lemma left_behind_a_share share l k : (forall a v, (a, v) ∈ share -> v ∈ Parte) -> left_behind share l k -> k ∈ Parte.
Proof.
  intros S. revert k. induction l as [| a l IH]; cbn; [intros k ->; unfold Parte; lra |].
  intros k [u [v [Hu [Hv ->]]]]. destruct (IH u Hu) as [U0 U1]. destruct (S _ _ Hv) as [V0 V1].
  assert (0 <= u * v) by now apply Rmult_le_pos.
  assert (u * v <= u * 1) by now apply Rmult_le_compat_l.
  unfold Parte. lra.
Qed.
End Through.

Section Sheets.
Variable Elemento : Type.
Implicit Types (S : rel Elemento Punto) (paso : rel (Elemento * Punto) R).

(** What is counted is a list, in which each member stands once. *)
Lemma counted S paso k : functional paso -> transmitido S paso k ->
  exists l, NoDup l /\ (forall a, In a l <-> a ∈ S) /\ left_behind (Elemento * Punto) paso l k.
Proof.
  intros F [n [c [dada [resto [[z ->] [Hc [Hd [Hr [[N [Into [Once All]]] [Given [[[v0 [R0 ->]] Next] [r [Rn ->]]]]]]]]]]]]].
  set (Up m := (m <= z)%Z -> exists l, NoDup l
    /\ (forall a, In a l <-> exists i, (0 <= i < m)%Z /\ (IZR i, a) ∈ c)
    /\ exists r, (IZR m, r) ∈ resto /\ left_behind (Elemento * Punto) paso l r).
  assert (U : forall m, (0 <= m)%Z -> Up m).
  { apply natlike_ind; unfold Up.
    - intros _. exists nil. split; [constructor |]. split.
      + intros a. split; [easy |]. intros [i [[? ?] _]]. lia.
      + now exists 1.
    - intros m Hm IH Hle. destruct IH as [l [D [Mem [u [Hu Lu]]]]]; [lia |].
      destruct (Next (IZR m) (integer m)) as [r' [u' [d [Hr' [Hu' [Hd' ->]]]]]]; [now apply Rle_ge, IZR_le |].
      destruct (Given (IZR m) (integer m)) as [d' [a [v [Hd'' [Ha [Hv ->]]]]]].
      pose proof (one_value _ _ _ _ _ _ Hr Hu' Hu) as ->. pose proof (one_value _ _ _ _ _ _ Hd Hd' Hd'') as ->.
      exists (a :: l). split; [| split].
      + constructor; [| exact D]. intros In_l. apply Mem in In_l as [i [[I0 I1] Hi]].
        destruct (Once (IZR i) (IZR m) (integer i) (integer m)) as [a1 [a2 [H1 [H2 Ne]]]].
        * split; [now apply IZR_le | now apply IZR_lt].
        * apply IZR_lt. lia.
        * apply Ne. now rewrite (one_value _ _ _ _ _ _ Hc H1 Hi), (one_value _ _ _ _ _ _ Hc H2 Ha).
      + intros b. cbn. rewrite Mem. split.
        * intros [<- | [i [[I0 I1] Hi]]]; [exists m | exists i]; (split; [lia | assumption]).
        * intros [i [[I0 I1] Hi]]. destruct (Z.eq_dec i m) as [-> | Hne].
          -- left. exact (one_value _ _ _ _ _ _ Hc Ha Hi).
          -- right. exists i. split; [lia | exact Hi].
      + exists (u * v). split; [| now exists u, v].
        unfold Z.succ. now rewrite plus_IZR. }
  assert (Hz : (0 <= z)%Z) by (apply le_IZR; lra).
  destruct (U z Hz (Z.le_refl z)) as [l [D [Mem [r' [Hr' L]]]]].
  rewrite (one_value _ _ _ _ _ _ Hr Rn Hr'). exists l. split; [exact D |]. split; [| exact L].
  intros a. rewrite Mem. split.
  - intros [i [[I0 I1] Hi]]. destruct (Into (IZR i) (integer i)) as [b [Hb Sb]].
    + split; [now apply IZR_le | now apply IZR_lt].
    + now rewrite (one_value _ _ _ _ _ _ Hc Hi Hb).
  - intros Sa. destruct (All a Sa) as [i [[j ->] [[I0 I1] [b [Hb ->]]]]]. exists j.
    split; [| exact Hb]. split; [now apply le_IZR | now apply lt_IZR].
Qed.

(** Discharges enumerado.def.1, atenuado.def.1, transmitido.def.1, transmitido.conj.1. *)
Theorem what_is_let_through_has_no_order : transmitido_conj_1 Elemento.
Proof.
  intros S paso k j [F _] Hk Hj.
  destruct (counted S paso k F Hk) as [l [D [Mem L]]]. destruct (counted S paso j F Hj) as [l' [D' [Mem' L']]].
  apply (left_behind_one _ _ _ _ _ F L).
  apply (left_behind_in_any_order _ _ l' l); [| exact L'].
  apply NoDup_Permutation; try assumption. intros a. now rewrite Mem, Mem'.
Qed.

(** Discharges transmitido.conj.2. *)
Theorem nothing_takes_nothing_and_a_stone_takes_all : transmitido_conj_2 Elemento.
Proof.
  intros S paso k [F _] Hk. destruct (counted S paso k F Hk) as [l [_ [Mem L]]]. split.
  - intros E. destruct l as [| a l]; [exact L |]. destruct (E a) as [No _]. destruct No. apply Mem. now left.
  - intros [a [Sa [v [Hv ->]]]]. apply (left_behind_nothing _ _ l a k F); [now apply Mem | exact Hv | exact L].
Qed.

(** Discharges transmitido.conj.3. *)
Theorem of_shares_it_is_a_share : transmitido_conj_3 Elemento.
Proof.
  intros S paso k [F [_ Ran]] Hk. destruct (counted S paso k F Hk) as [l [_ [_ L]]].
  apply (left_behind_a_share _ paso l); [| exact L]. intros a v H. apply Ran. now exists a.
Qed.
End Sheets.

(** One pane before a light, of which it lets a half through. *)
Theorem one_pane_lets_its_share_through : exists (S : rel unit Punto) paso, paso ∈ univ ⟶ Parte /\ transmitido S paso (1 / 2).
Proof.
  set (pane := (tt, mk_Punto 0 0 0)).
  exists (single pane), (fun p => snd p = 1 / 2). split.
  - split; [| split].
    + intros a k j; cbn; congruence.
    + intros a. split; [easy |]. intros _. now exists (1 / 2).
    + intros k [a Hk]. cbn in Hk. subst k. unfold Parte. lra.
  - exists 1, (fun p => fst p ∈ integers /\ snd p = pane), (fun p => fst p ∈ integers /\ snd p = 1 / 2),
      (fun p => exists z, fst p = IZR z /\ snd p = (1 / 2) ^ Z.to_nat z).
    assert (Total : forall (X : Type) (x : X), (fun p : R * X => fst p ∈ integers /\ snd p = x) ∈ integers ⟶ univ).
    { intros X x. split; [| split; [| easy]].
      - intros i k j [_ E] [_ F]. cbn in E, F. congruence.
      - intros i. split; [now intros [k [Hi _]] |]. intros Hi. exists x. now split. }
    split; [now exists 1%Z |]. split; [apply Total |]. split; [apply Total |]. split; [| split; [| split; [| split]]].
    + split; [| split; [| easy]].
      * intros i k j [z [Ez Hz]] [y [Ey Hy]]. cbn in *. subst i. apply eq_IZR in Ey. now subst.
      * intros i. split; [intros [k [z [Ez _]]]; now exists z |]. intros [z ->]. exists ((1 / 2) ^ Z.to_nat z). now exists z.
    + split; [lra |]. split; [| split].
      * intros i Hi _. exists pane. now repeat split.
      * intros i j [y ->] [z ->] [H0 Hy] Hz. apply le_IZR in H0. apply lt_IZR in Hy, Hz. lia.
      * intros a ->. exists 0. split; [now exists 0%Z |]. split; [lra |]. exists pane. repeat split. now exists 0%Z.
    + intros i Hi. exists (1 / 2), pane, (1 / 2). now repeat split.
    + split.
      * exists 1. split; [now exists 0%Z | reflexivity].
      * intros i [z ->] Hz. apply Rge_le, le_IZR in Hz.
        exists ((1 / 2) ^ Z.to_nat (z + 1)), ((1 / 2) ^ Z.to_nat z), (1 / 2).
        split; [exists (z + 1)%Z; split; [cbn; now rewrite plus_IZR | reflexivity] |]. split; [now exists z |].
        split; [split; [now exists z | reflexivity] |].
        replace (Z.to_nat (z + 1)) with (Datatypes.S (Z.to_nat z)) by (rewrite <- Z2Nat.inj_succ by exact Hz; reflexivity).
        rewrite <- tech_pow_Rmult. ring.
    + exists (1 / 2). split; [| reflexivity]. exists 1%Z. split; [reflexivity |]. cbn [snd].
      change (Z.to_nat 1) with 1%nat. now rewrite pow_1.
Qed.

(** Discharges menguada.def.1, menguada.conj.1. *)
Theorem of_a_share_of_a_light_its_share_is_sent_back : menguada_conj_1.
Proof. intros m n v f g k _ _ _ _ [Hl [HS HV]]. unfold aportacion. rewrite Hl, HS, HV. ring. Qed.

(** ** A light that shines into a cone *)

(** The smooth step is a share. *)
Lemma a_smooth_step_is_a_share x : x ∈ Parte -> x * x * (3 - 2 * x) ∈ Parte.
Proof.
  intros [H0 H1]. assert (P : 0 <= x * x) by now apply Rmult_le_pos.
  assert (Q : 0 <= (1 - x) * (1 - x) * (1 + 2 * x)) by (repeat apply Rmult_le_pos; lra).
  split; [apply Rmult_le_pos; lra |].
  replace (x * x * (3 - 2 * x)) with (1 - (1 - x) * (1 - x) * (1 + 2 * x)) by ring. lra.
Qed.

Lemma a_product_of_shares x y : x ∈ Parte -> y ∈ Parte -> x * y ∈ Parte.
Proof.
  intros [X0 X1] [Y0 Y1]. split; [now apply Rmult_le_pos |].
  assert (x * y <= x * 1) by now apply Rmult_le_compat_l. lra.
Qed.

(** A light that shines upwards. *)
Lemma a_cone_of_light : mk_Cono_de_Luz (mk_Vector 0 0 1) (4 / 5) (3 / 5) 2 ∈ Cono_de_Luz_ok.
Proof. split; cbn; [components; cbn; ring | lra | unfold Cantidad; lra]. Qed.

(** Discharges Cono_de_Luz.inv.1, Cono_de_Luz.inv.2, Cono_de_Luz.inv.3, intensidad.def.1, intensidad.conj.1. *)
Theorem a_cone_sends_one_share_each_way : intensidad_conj_1.
Proof.
  intros [eje f b e] w [He [B0 [Bf F1]] Ee] Hw. cbn in *.
  set (p := producto eje w). assert (P1 : p <= 1) by now apply producto_below_one.
  assert (Pow : b <= p -> elevado p e ∈ Parte).
  { intros Hb. split; [apply power_not_negative |].
    apply no_power_of_a_share_is_above_one; [split; lra | exact Ee]. }
  assert (One : exists! k, intensidad (mk_Cono_de_Luz eje f b e) w k).
  { unfold intensidad. cbn. fold p.
    destruct (Rlt_dec p b) as [Out | In_].
    - exists 0. split; [repeat split; intros; lra |]. intros k [_ [K _]]. symmetry. now apply K.
    - destruct (Rlt_dec p f) as [Mid | Full].
      + set (x := (p - b) / (f - b)).
        assert (E : x * (f - b) = p - b) by (unfold x; field; lra).
        exists (elevado p e * (x * x * (3 - 2 * x))). split.
        * repeat split; intros; try lra. exists x. repeat split; try exact E.
          -- apply Rmult_le_pos; [lra |]. apply Rlt_le, Rinv_0_lt_compat. lra.
          -- apply Rmult_le_reg_r with (f - b); lra.
        * intros k [_ [_ [_ K]]]. destruct K as [y [_ [Ey ->]]]; [lra |].
          replace y with x; [reflexivity |]. apply Rmult_eq_reg_r with (f - b); lra.
      + exists (elevado p e). split; [repeat split; intros; lra |]. intros k [_ [_ [K _]]]. symmetry. apply K. lra. }
  split; [exact One |].
  intros k [_ [Out [Full Mid]]]. cbn in *. fold p in Out, Full, Mid.
  destruct (Rlt_dec p b) as [H | H]; [rewrite Out by exact H; unfold Parte; lra |].
  destruct (Rlt_dec p f) as [H' | H'].
  - destruct Mid as [x [Hx [_ ->]]]; [lra |]. apply a_product_of_shares; [apply Pow; lra |].
    now apply a_smooth_step_is_a_share.
  - rewrite Full by lra. apply Pow. lra.
Qed.

(** Discharges intensidad.conj.2. *)
Theorem a_cone_is_full_along_its_axis_and_ends_without_a_step : intensidad_conj_2.
Proof.
  intros [eje f b e] w k [He [B0 [Bf F1]] Ee] [Hw [Out [Full Mid]]]. cbn in *. split.
  - intros ->. rewrite Full by lra. rewrite He. unfold elevado.
    destruct the_power_has_the_laws as [_ [Laws _]].
    destruct (Laws 1) as [_ [_ H]]; [unfold Cantidad; lra |]. apply (Laws e Ee).
  - intros [E Lt]. destruct Mid as [x [_ [Ex ->]]]; [lra |].
    assert (Z : x * (f - b) = 0 * (f - b)) by lra.
    apply Rmult_eq_reg_r in Z; [| lra]. rewrite Z. ring.
Qed.
