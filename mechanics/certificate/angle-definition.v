(* The angle of the point (x, y), from - PI to PI, and its sine and cosine *)
Definition atan2 (y x : R) : R :=
  if Rlt_dec 0 x then atan (y / x)
  else if Rlt_dec 0 y then PI / 2 - atan (x / y)
  else if Rlt_dec y 0 then - (PI / 2) - atan (x / y)
  else PI.

Lemma hypotenuse_by_leg : forall x y : R, 0 < x -> sqrt (1 + (y / x) ^ 2) = sqrt (x * x + y * y) / x.
Proof.
  intros x y P. apply Rmult_eq_reg_r with x; [| lra].
  replace (sqrt (x * x + y * y) / x * x) with (sqrt (x * x + y * y)) by (field; lra).
  rewrite <- (sqrt_square x) at 2 by lra. rewrite <- sqrt_mult by nra. f_equal. field. lra.
Qed.
Lemma wave_of_angle : forall x y : R, x * x + y * y <> 0 ->
  sin (atan2 y x) = y / sqrt (x * x + y * y) /\ cos (atan2 y x) = x / sqrt (x * x + y * y).
Proof.
  assert (waves : forall x y : R, 0 < x -> sin (atan (y / x)) = y / sqrt (x * x + y * y) /\
                                       cos (atan (y / x)) = x / sqrt (x * x + y * y)).
  { intros x y P. assert (0 < sqrt (x * x + y * y)) by (apply sqrt_lt_R0; nra).
    rewrite Ratan.sin_atan, Ratan.cos_atan, Rsqr_pow2, hypotenuse_by_leg by exact P.
    split; field; lra. }
  intros x y N. unfold atan2.
  destruct (Rlt_dec 0 x) as [P | P]; [exact (waves x y P) |].
  assert (0 < sqrt (x * x + y * y)) by (apply sqrt_lt_R0; nra).
  destruct (Rlt_dec 0 y) as [Q | Q].
  { destruct (waves y x Q) as [S C]. rewrite sin_shift, cos_shift, S, C, (Rplus_comm (y * y)).
    split; reflexivity. }
  destruct (Rlt_dec y 0) as [M | M].
  { destruct (waves (- y) (- x)) as [S C]; [lra |].
    replace (- x / - y) with (x / y) in S, C by (field; lra).
    replace (- y * - y + - x * - x) with (x * x + y * y) in S, C by ring.
    replace (- (PI / 2) - atan (x / y)) with (- (PI / 2 - - atan (x / y))) by ring.
    rewrite sin_neg, cos_neg, sin_shift, cos_shift, sin_neg, cos_neg, S, C.
    split; field; lra. }
  assert (y = 0) by lra. subst y. rewrite sin_PI, cos_PI.
  replace (x * x + 0 * 0) with (- x * - x) by ring. rewrite sqrt_square by lra.
  split; field; nra.
Qed.
