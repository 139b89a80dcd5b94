#lang racket/base
;; Is a value zero, are two values equal?
;;
;; The algebra judges scalars one by one, of a structure, a matrix or a series each.
;; A function is judged by its value at symbolic arguments.

(require racket/list
         "derivative-survey.rkt" "residual-remarks.rkt" "vanishing-conditions.rkt" "verdict.rkt"
         "../algebra/expression/expression.rkt" "../algebra/expression/nodes.rkt"
         "../algebra/expression/operation.rkt"
         "../algebra/expression/read.rkt" "../algebra/expression/substitute.rkt"
         "../algebra/expression/symbols.rkt"
         "../error/complain.rkt" "../error/computed-once.rkt" "../error/failure.rkt"
         "../error/hint.rkt"
         "../error/message-words.rkt"
         "../generic/arithmetic.rkt" "../generic/describe.rkt" "../generic/function.rkt"
         "../generic/kind.rkt" "../generic/irrational.rkt" "../generic/up-down.rkt"
         "../generic/wrong-argument.rkt"
         "../value/algebra.rkt" "../value/assumptions.rkt" "../value/operator.rkt"
         "../value/series/series-access.rkt" "../value/series/series.rkt")

(provide prove-zero verify-equal)

;; ---------------------------------------------------------------------------
;; Judging

;; x : a value, or a function, which is judged at symbolic arguments.
;; names : symbols that no condition may speak of, as x must vanish whatever they are
;; surveys : points met by the derivatives x was made with; if that leaves places where
;; they do not tell, x is not proved.  A procedure that gives the list is called if needed.
;; remarks : -> strings, on matters that the verdict leaves out
;; meaning : #f, or a procedure that gives the meaning that the question has to keep under
;; the conditions that are told (vanishing-conditions.rkt)
;; domain : -> expressions that are to have a real value as well, in the symbols of x
;; motion-domain : of a motion, a function of the time: symbol of the time -> expressions; or #f
;; relied-on : datums of assumptions under which x is the question
;; again : #f, or a procedure that asks the question again, given the changes in it (verdict.rkt)
;; subject : #f, or the question, for a certificate of it: its name and its matter
(define (prove-zero x #:variables [names '()] #:surveys [surveys '()]
                    #:remarks [remarks (lambda () '())] #:meaning [meaning #f]
                    #:domain [domain (lambda () '())] #:motion-domain [motion-domain #f]
                    #:resting-on [relied-on '()] #:again [again #f] #:about [subject #f])
  (define variables (table-of-variables names))
  (define endless? #f)
  (define (note-endless!) (set! endless? #t))
  (define in-force (assumptions-in-force))
  (define-values (judged missing rested-on)
    (value-judged x variables note-endless! relied-on (not motion-domain)))
  (define arguments (remove* names (hash-keys variables)))
  (define beside
    (domain-expressions (if motion-domain (domain-along motion-domain arguments) (domain))))
  (define A (common-assumptions (with-relations (with-domain in-force beside) rested-on) judged))
  (define kinks (once (lambda () (kinks-of surveys rested-on in-force))))
  (define-values (residual tests) (judge-all judged A (hash-keys variables) kinks))
  (make-verdict residual (map cdr tests) (assumptions 'declared) endless? kinks
                (lambda (status)
                  (append (remarks-on-residual residual status (map cdr tests))
                          (if (eq? status 'undecided)
                              (append missing (remarks-on-domain beside (map cdr tests) A))
                              (remarks))))
                (once (lambda () (ways-told tests meaning A)))
                (or again
                    (lambda (change)
                      (prove-zero (change x) #:variables names #:surveys surveys
                                  #:remarks remarks #:meaning meaning #:domain domain
                                  #:motion-domain motion-domain #:resting-on relied-on)))
                (claim judged beside subject)))

;; -> the residual, and ((scalar . test) ...) for the scalars of x
(define (judge-all x A variables kinks)
  (define tests '())
  (define known (make-hash))            ; tensors have equal components
  (define residual
    (map-leaves (lambda (given)
                  (define leaf (irrational-as-expression given))
                  (define z (hash-ref! known leaf (lambda () (judge leaf A variables kinks))))
                  (set! tests (cons (cons leaf z) tests))
                  (note-used! (zero-test-grounds z))
                  (zero-test-residual z))
                x))
  (values residual (reverse tests)))

;; -> the value of x at symbolic arguments, strings on why it has none, and assumptions
(define (value-judged x variables note-endless! relied-on certain?)
  (define found '())
  (define (rely-on! relations) (set! found (append found relations)))
  (define-values (value missing)
    (call-for-value
     (lambda () (at-symbolic-arguments x '() '() variables note-endless! rely-on!))
     certain?))
  (values value missing (append relied-on (remove-duplicates found))))

;; -> the value, and no strings.  Where a motion has a derivative nowhere, as √(x² + y²) at rest in
;; the origin, it is no number, and strings say so.
(define (call-for-value find-value certain?)
  (if certain?
      (values (find-value) '())
      (with-handlers ([no-value? (lambda (e) (values +nan.0 (list (exn-message e))))])
        (values (find-value) '()))))

;; names : those of the arguments at which a motion was judged; none if its value is a number
(define (domain-along motion-domain names)
  (define t (string->uninterned-symbol "t"))
  (define found (motion-domain t))
  (define time
    (if (or (null? names) (ormap (lambda (e) (occurs? (car names) e)) found)) t (car names)))
  (for/list ([e (in-list found)]) (in-place-of (list (cons t time)) e)))

;; Strings: the part of the question that has no value, if that is the reason
(define (remarks-on-domain domain tests A)
  (define part
    (and (ormap (lambda (z) (eq? (zero-test-reason z) 'nowhere)) tests)
         (part-without-value domain A)))
  (cond [(not part) '()]
        [(headed? part op:up)
         (list (format "at no point do all of these have real values: ~a"
                       (joined (map value->text (node-args part)) ", ")))]
        [else (list (format "~a has no real value" (value->text part)))]))

;; Strings; decimals that stand in the way of a decision are in the tests' own reports.
(define (remarks-on-residual residual status tests)
  (define (rounding? z) (eq? (zero-test-reason z) 'rounding))
  (append (cond [(ormap rounding? tests) (remarks-on-rounding residual 0.0)]
                [(eq? status 'undecided) '()]
                [else (remarks-on-rounding residual)])
          (remarks-on-pi residual)))

;; tests : ((expression . test) ...); find-meaning : #f or -> meaning, called if needed
;; -> for each the ways to make it zero, and those for all of them
(define (ways-told tests find-meaning A)
  (define (open? t) (not (eq? (zero-test-status (cdr t)) 'proved)))
  (define any? (for/or ([t (in-list tests)]) (and (open? t) (pair? (zero-test-ways (cdr t))))))
  (define given (and any? find-meaning (find-meaning)))
  (define ways
    (for/list ([t (in-list tests)])
      (if (and any? (open? t)) (sensible-ways (cdr t) (car t) given A) '())))
  (values ways
          (ways-for-all (for/list ([w (in-list ways)] [t (in-list tests)] #:when (open? t)) w)
                        given A)))

;; -> the kinks of all surveys, and the grounds that there are not more, and else
(define (kinks-of surveys relied-on A)
  (define found
    (for/list ([s (in-list (if (procedure? surveys) (surveys) surveys))])
      (call-with-values (lambda () (s A)) list)))
  (values (remove-duplicates (append-map first found))
          (append relied-on (append-map second found))))

;; -> table of the symbols, each with #t
(define (table-of-variables names)
  (unless (and (list? names) (andmap symbol? names))
    (complain-of-argument 'prove-zero "the variables, a list of symbols" names))
  (make-hasheq (for/list ([s (in-list names)]) (cons s #t))))

;; kinks-found : -> kinks and grounds
(define (judge leaf A variables kinks-found)
  (unless (expression? leaf)
    (complain-of-argument 'prove-zero "a number, an expression, a tuple of them, or a function"
                          leaf (quoted-hint leaf)))
  (define z (zero-test leaf A variables))
  (define-values (kinks _)
    (if (and (eq? (zero-test-status z) 'refuted) (looks-at-jumps? leaf))
        (kinks-found)
        (values '() '())))
  (define elsewhere (assumptions-off-kinks A kinks (or (zero-test-witness z) '())))
  (if elsewhere (zero-test leaf elsewhere variables) z))

(define (verify-equal a b)
  (define v (prove-zero (difference a b) #:about (equality-claim a b)))
  (define conditions
    (if (proved? v)
        (append-map (lambda (e) (unexpected-domain e (assumptions-in-force)))
                    (filter expression? (list a b)))
        '()))
  (if (null? conditions)
      v
      (with-remark v (format "both sides are real where ~a"
                             (joined (map value->text (remove-duplicates conditions)) ", ")))))

;; a - b, where flonums are not subtracted yet: a loss by rounding shows
;; only beside the numbers themselves.  Beside 0 there is nothing to show it.
(define (difference a b)
  (cond [(eqv? b 0) a]
        [(eqv? a 0) (g:- b)]
        [(and (number? a) (number? b) (not (and (exact? a) (exact? b))))
         (make-node op:- (list a b))]
        [(and (tuple? a) (tuple? b) (compatible? (adopt a) (adopt b)))
         (structure-map2 difference (adopt a) (adopt b))]
        [else
         (for ([f (in-list (list a b))] #:when (procedure? f)) (check-keywords f))
         (g:- (irrational-as-expression a) (irrational-as-expression b))]))

;; x with the up tuple of its terms in place of a series; of one that does not end
;; as many as are compared, and (note!) is called.
(define (with-terms x note!)
  (cond [(series? x)
         (define endless? (not (finite-series? x)))
         (when endless? (note!))
         (apply up (series:head x (if endless? compared-terms (series-length x))))]
        [(tuple? x) (structure-map (lambda (e) (with-terms e note!)) (adopt x))]
        [else x]))

;; ---------------------------------------------------------------------------
;; Functions are judged at symbolic arguments

;; A function, wherever it stands in x, is taken at symbols of its own, which
;; occur nowhere else; its value may be a function again.  In the result they
;; are renamed to t, or t0 t1 ... if there are several, or to the next name if
;; the user has a t already.  Their names are added to the table `variables`.  A kind of value
;; that is judged so may say which expressions of its arguments are positive: (rely-on! relations).
(define (at-symbolic-arguments x arguments positive variables note! rely-on!)
  (map-leaves
   (lambda (leaf)
     (define (judge-instead value fresh [positive-now '()])
       (at-symbolic-arguments value (append arguments fresh) (append positive positive-now)
                              variables note! rely-on!))
     (cond [(operator? leaf) (raise-operator leaf)]
           [(and (has-kind? leaf) (kind-judged (kind-of leaf)))
            => (lambda (judged) (call-with-values (lambda () (judged leaf)) judge-instead))]
           [(procedure? leaf)
            (define fresh (fresh-arguments leaf))
            (judge-instead (apply leaf fresh) fresh)]
           [(or (symbolic? leaf) (pair? positive))
            (define new-names (names-beside leaf arguments variables))
            (rely-on! (for/list ([e (in-list positive)])
                        (list '> (expression->datum (substitute-expression e new-names)) 0)))
            (if (symbolic? leaf) (substitute-expression leaf new-names) leaf)]
           [else leaf]))
   (with-terms x note!)))

(define (raise-operator o)
  (complain 'prove-zero
            "~a is an operator; give it a function to act on, as in (~a (literal-function 'f))"
            (value->text o) (value->text o)))

(define (fresh-arguments f)
  (check-keywords f)
  (define n (for/first ([n (in-sequences (in-range 1 21) '(0))] #:when (accepts? f n)) n))
  (unless n
    (complain-showing 'prove-zero "cannot choose arguments for the function" "function" f))
  (for/list ([i (in-range n)])
    (string->uninterned-symbol (if (= n 1) "t" (format "t~a" i)))))

;; No values are known for the keywords that a function requires.
(define (check-keywords f)
  (define-values (required known) (procedure-keywords f))
  (when (pair? required)
    (define names (map keyword->string required))
    (complain 'prove-zero
              (string-append "expected a function of arguments without keywords\n  given: ~a, "
                             "which requires ~a\n  give it values for them, "
                             "as in (lambda (x) (f x ~a))")
              (value->text f)
              (joined (for/list ([k (in-list names)]) (string-append "#:" k)) " and ")
              (joined (for/list ([k (in-list names)]) (format "#:~a ~a" k k)) " "))))

;; -> ((argument . name) ...)
(define (names-beside e arguments variables)
  (define symbols (if (symbolic? e) (symbols-in e) '()))
  (define taken (make-hasheq (for/list ([s (in-list symbols)]) (cons s #t))))
  (for/list ([a (in-list arguments)])
    (define name (unused-name (symbol->string a) taken))
    (hash-set! taken name #t)
    (hash-set! variables name #t)
    (cons a name)))

;; ---------------------------------------------------------------------------
;; Refutations at points where derivatives do not see a jump are none: at t = 0 the derivative of
;; cos(t sgn t), which is cos t, is not that by a formula with sgn 0 = 0.  Points elsewhere
;; are asked for.

;; Is there a jump, of sgn, in e?
(define (looks-at-jumps? e)
  (some-node? (lambda (n) (headed? n op:sgn)) e))

;; A with relations that exclude the kinks on which the witness lies; #f if it lies on none.
(define (assumptions-off-kinks A kinks witness)
  (define there
    (for*/list ([k (in-list kinks)]
                [u (in-value (vanishing k))]
                #:when (and u (vanishes-at? u witness)))
      (list '> (list 'expt (expression->datum u) 2) 0)))
  (and (pair? there) (declare-relations A there)))

;; An expression that vanishes at the kink, by its first equation; #f for a family of places.
(define (vanishing k)
  (define equations (kink-equations k))
  (and (pair? equations)
       (not (kink-family? k))
       (e:- (datum->expression (cadr (car equations)))
            (datum->expression (caddr (car equations))))))

(define (vanishes-at? u witness)
  (define x (substitute-expression u witness))
  (and (number? x) (zero? x)))
