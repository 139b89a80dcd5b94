(* How the proofs below go on: nothing here is assumed, all is proved from Coq's library. *)

Lemma sine_squared : forall x : R, sin x * sin x = 1 - cos x * cos x.
Proof. intro x. pose proof (sin2_cos2 x) as H. unfold Rsqr in H. lra. Qed.

Lemma modulus_squared : forall x : R, Rabs x * Rabs x = x * x.
Proof. intro x. rewrite <- Rabs_mult. apply Rabs_pos_eq. apply Rle_0_sqr. Qed.

Lemma modulus_is : forall u w : R, 0 <= w -> w * w = u * u -> Rabs u = w.
Proof.
  intros u w H E. rewrite <- (Rabs_pos_eq w H).
  apply Rsqr_eq_abs_0. unfold Rsqr. symmetry. exact E.
Qed.

Lemma and_later : forall A B : Prop, A -> (A -> B) -> A /\ B.
Proof. tauto. Qed.

(* Arcs, with x * x for Coq's Rsqr x *)
Lemma sin_asin : forall x : R, -1 <= x <= 1 -> sin (asin x) = x.
Proof. exact Ratan.sin_asin. Qed.
Lemma cos_asin : forall x : R, -1 <= x <= 1 -> cos (asin x) = sqrt (1 - x * x).
Proof. exact Ratan.cos_asin. Qed.
Lemma sin_acos : forall x : R, -1 <= x <= 1 -> sin (acos x) = sqrt (1 - x * x).
Proof. exact Ratan.sin_acos. Qed.
Lemma cos_acos : forall x : R, -1 <= x <= 1 -> cos (acos x) = x.
Proof. exact Ratan.cos_acos. Qed.
Lemma sin_atan : forall x : R, sin (atan x) = x / sqrt (1 + x * x).
Proof. exact Ratan.sin_atan. Qed.
Lemma cos_atan : forall x : R, cos (atan x) = 1 / sqrt (1 + x * x).
Proof. exact Ratan.cos_atan. Qed.
Lemma hypotenuse_nonzero : forall x : R, sqrt (1 + x * x) <> 0.
Proof. intro x. apply Rgt_not_eq, sqrt_lt_R0. pose proof (Rle_0_sqr x). unfold Rsqr in *. lra. Qed.
Ltac bounds := split; lra.
Ltac radicand := nra.

Ltac turns :=
  repeat rewrite ?Ropp_0, ?sin_plus, ?cos_plus, ?sin_neg, ?cos_neg, ?sin_0, ?cos_0; ring.
Ltac exponents :=
  repeat rewrite ?Ropp_0, ?exp_plus, ?exp_Ropp, ?exp_0; field; repeat split; apply Rgt_not_eq, exp_pos.

(* Powers of e to parts of logarithms *)
Lemma exp_part_2 : forall x y : R, 0 < x -> y + y = ln x -> exp y ^ 2 = x.
Proof. intros x y H E. rewrite <- (exp_ln x H), <- E, exp_plus. ring. Qed.
Lemma exp_part_3 : forall x y : R, 0 < x -> y + y + y = ln x -> exp y ^ 3 = x.
Proof. intros x y H E. rewrite <- (exp_ln x H), <- E, !exp_plus. ring. Qed.
Lemma exp_part_4 : forall x y : R, 0 < x -> y + y + y + y = ln x -> exp y ^ 4 = x.
Proof. intros x y H E. rewrite <- (exp_ln x H), <- E, !exp_plus. ring. Qed.
Lemma exp_part_5 : forall x y : R, 0 < x -> y + y + y + y + y = ln x -> exp y ^ 5 = x.
Proof. intros x y H E. rewrite <- (exp_ln x H), <- E, !exp_plus. ring. Qed.
Lemma exp_part_6 : forall x y : R, 0 < x -> y + y + y + y + y + y = ln x -> exp y ^ 6 = x.
Proof. intros x y H E. rewrite <- (exp_ln x H), <- E, !exp_plus. ring. Qed.

(* Of a divisor that is not 0 its factors are not. *)
Lemma power_nonzero : forall (x : R) (n : nat), x ^ S n <> 0 -> x <> 0.
Proof. intros x n H E. apply H. rewrite E. simpl. ring. Qed.
Lemma left_factor : forall x y : R, x * y <> 0 -> x <> 0.
Proof. intros x y H E. apply H. rewrite E. ring. Qed.
Lemma right_factor : forall x y : R, x * y <> 0 -> y <> 0.
Proof. intros x y H E. apply H. rewrite E. ring. Qed.
Lemma radicand_positive : forall x : R, sqrt x <> 0 -> 0 < x.
Proof. intros x H. apply Rnot_le_lt. intro. apply H, sqrt_neg_0. assumption. Qed.
Ltac new_nonzero x proof :=
  lazymatch x with IZR _ => fail | _ => idtac end;
  lazymatch goal with _ : x <> 0 |- _ => fail | _ => assert (x <> 0) by exact proof end.
Ltac divisors :=
  repeat match goal with
  | H : sqrt ?x <> 0 |- _ => new_nonzero x (Rgt_not_eq _ _ (radicand_positive _ H))
  | H : ?x ^ S _ <> 0 |- _ => new_nonzero x (power_nonzero _ _ H)
  | H : ?x * _ <> 0 |- _ => new_nonzero x (left_factor _ _ H)
  | H : _ * ?x <> 0 |- _ => new_nonzero x (right_factor _ _ H)
  end.

(* Signs, by the form of an expression and by what is given. *)
Lemma right_sign : forall x y : R, 0 <= x * y -> 0 < x -> 0 <= y.
Proof. intros x y H P. apply (Rmult_le_reg_l x); [exact P | rewrite Rmult_0_r; exact H]. Qed.
Lemma left_sign : forall x y : R, 0 <= x * y -> 0 < y -> 0 <= x.
Proof. intros x y. rewrite Rmult_comm. apply right_sign. Qed.
Ltac positive :=
  first [ assumption | lra
        | match goal with
          | |- 0 < _ * _ => apply Rmult_lt_0_compat; positive
          | |- 0 < _ / _ => apply Rdiv_lt_0_compat; positive
          | |- 0 < / _ => apply Rinv_0_lt_compat; positive
          | |- 0 < sqrt _ => apply sqrt_lt_R0; positive
          | |- 0 < exp _ => apply exp_pos
          | |- 0 < Rpower _ _ => apply exp_pos
          | |- 0 < exp _ - exp _ => apply Rlt_Rminus, exp_increasing; lra
          | |- 0 < _ ^ _ => apply pow_lt; positive
          | |- 0 < Rabs _ => apply Rabs_pos_lt; nonzero_factor
          | |- 0 < _ + _ => first [ apply Rplus_lt_0_compat; positive
                                  | apply Rplus_lt_le_0_compat; [positive | nonnegative]
                                  | apply Rplus_le_lt_0_compat; [nonnegative | positive] ]
          end
        | match goal with
          | H : ?x <> 0 |- 0 < ?x =>
              apply Rnot_le_lt; intro; apply H; apply Rle_antisym; [assumption | nonnegative]
          | H : sqrt ?x <> 0 |- 0 < ?x => exact (radicand_positive x H)
          | H : ?x <> 0 |- 0 < ?x * ?x => apply Rsqr_pos_lt, H
          | H : ?x <> 0 |- 0 < ?x ^ 2 => rewrite <- Rsqr_pow2; apply Rsqr_pos_lt, H
          end
        | nra ]
with nonnegative :=
  first [ assumption | lra
        | match goal with
          | |- 0 <= sqrt _ => apply sqrt_pos
          | |- 0 <= Rabs _ => apply Rabs_pos
          | |- 0 <= ?x * ?x => apply Rle_0_sqr
          | |- 0 <= _ ^ 2 => apply pow2_ge_0
          | |- 0 <= _ * _ => apply Rmult_le_pos; nonnegative
          | |- 0 <= _ / _ => apply Rmult_le_pos; [nonnegative | nonnegative]
          | |- 0 <= / _ => left; apply Rinv_0_lt_compat; positive
          | |- 0 <= _ ^ _ => apply pow_le; nonnegative
          | |- 0 <= _ + _ => apply Rplus_le_le_0_compat; nonnegative
          end
        | match goal with
          | H : 0 <= ?x / ?y |- 0 <= ?x =>
              replace x with (x / y * y) by (field; nonzero_factor);
              apply Rmult_le_pos; [exact H | nonnegative]
          | H : 0 < ?x / ?y |- 0 <= ?x =>
              replace x with (x / y * y) by (field; nonzero_factor);
              apply Rmult_le_pos; [left; exact H | nonnegative]
          | H : 0 <= ?p |- 0 <= ?x => lazymatch p with context [x] => sign_of x H end
          end
        | left; positive
        | nra ]
with sign_of x H :=                     (* of a factor x in what H says not to be negative *)
  lazymatch type of H with
  | 0 <= x => exact H
  | 0 <= ?a * ?b =>
      let G := fresh in
      lazymatch b with
      | context [x] => assert (G : 0 <= b) by (apply (right_sign a b H); clear H; positive)
      | _ => assert (G : 0 <= a) by (apply (left_sign a b H); clear H; positive)
      end; sign_of x G
  end
with nonzero_factor :=
  first [ assumption
        | lra
        | match goal with
          | |- _ * _ <> 0 => apply Rmult_integral_contrapositive_currified; nonzero_factor
          | |- _ ^ _ <> 0 => apply pow_nonzero; nonzero_factor
          | |- / _ <> 0 => apply Rinv_neq_0_compat; nonzero_factor
          | |- Rabs _ <> 0 => apply Rabs_no_R0; nonzero_factor
          | |- - _ <> 0 => apply Ropp_neq_0_compat; nonzero_factor
          end
        | match goal with
          | H : ?d <> 0 |- ?x <> 0 =>
              let Z := fresh "Z" in
              intro Z; apply H; solve [ transitivity x; [ring | exact Z]
                                      | transitivity (- x); [ring | rewrite Z; ring] ]
          end
        | apply not_eq_sym, Rlt_not_eq; positive
        | match goal with
          | H : ?d <> 0 |- ?x <> 0 =>
              let Z := fresh "Z" in
              intro Z; apply H; solve [ rewrite Z; field; repeat split; assumption
                                      | rewrite Z; unfold Rdiv; ring
                                      | ring [Z] ]
          | H : ?d <> 0 |- ?x <> 0 =>
              let Z := fresh "Z" in
              intro Z; apply H; solve [ field_simplify_eq; [nsatz | repeat split; assumption]
                                      | nsatz ]
          end ].
Ltac nonzero := repeat split; nonzero_factor.

Ltac logarithms :=
  repeat first [ rewrite ln_mult by positive | rewrite ln_Rinv by positive | rewrite ln_1 ]; ring.

(* The sine and the cosine of parts of a turn *)
Lemma half_root : 1 / sqrt 2 = sqrt 2 / 2.
Proof.
  assert (E : sqrt 2 * sqrt 2 = 2) by (apply sqrt_sqrt; lra).
  assert (sqrt 2 <> 0) by (apply Rgt_not_eq, sqrt_lt_R0; lra).
  field_simplify_eq; [ring [E] | assumption].
Qed.
Ltac turn_1 := first [ rewrite sin_PI | rewrite cos_PI ]; ring.
Ltac turn_2 :=
  replace (1 / 2 * PI) with (PI / 2) by field; first [ rewrite sin_PI2 | rewrite cos_PI2 ]; ring.
Ltac turn_3 :=
  replace (1 / 3 * PI) with (PI / 3) by field; first [ rewrite sin_PI3 | rewrite cos_PI3 ]; field.
Ltac turn_4 :=
  replace (1 / 4 * PI) with (PI / 4) by field; first [ rewrite sin_PI4 | rewrite cos_PI4 ];
  rewrite half_root; field.
Ltac turn_6 :=
  replace (1 / 6 * PI) with (PI / 6) by field; first [ rewrite sin_PI6 | rewrite cos_PI6 ]; field.

(* At numbers between 0 and 3/2 sines and cosines are between 0 and 1. *)
Ltac bound_waves :=
  repeat match goal with
  | |- context [cos ?a] =>
      lazymatch goal with
      | H : 0 < cos a < 1 |- _ => fail
      | _ => assert (0 < cos a < 1) by
               (pose proof PI2_3_2; split; [apply cos_gt_0; lra |];
                apply Rlt_le_trans with (cos 0);
                [apply cos_decreasing_1; lra | rewrite cos_0; lra])
      end
  | |- context [sin ?a] =>
      lazymatch goal with
      | H : 0 < sin a < 1 |- _ => fail
      | _ => assert (0 < sin a < 1) by
               (pose proof PI2_3_2; split; [apply sin_gt_0; lra |];
                apply Rlt_le_trans with (sin (PI / 2));
                [apply sin_increasing_1; lra | rewrite sin_PI2; lra])
      end
  end.
Ltac know_roots :=
  repeat match goal with
  | |- context [sqrt ?a] =>
      lazymatch goal with
      | H : sqrt a * sqrt a = a |- _ => fail
      | _ => assert (sqrt a * sqrt a = a) by (apply sqrt_sqrt; nonnegative);
             assert (0 <= sqrt a) by apply sqrt_pos
      end
  end.
Ltac at_numbers :=
  first [ exact I | lra
        | unfold tanh, sinh, cosh; rewrite ?sin_atan, ?cos_atan; bound_waves;
          first [ lra | positive | nonnegative | nonzero
                | know_roots; first [ nra | intro; nra ] ] ].

