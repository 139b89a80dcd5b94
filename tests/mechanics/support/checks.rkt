#lang racket/base
;; The checks and test cases of rackunit, compiled in less time.
;;
;; A check of rackunit expands to functions with keywords, contracts and syntax objects, and there
;; are thousands of checks.  Here it is a call of `run-check` with a datum that says where the
;; check stands and how it reads.  Counting, and the words of a failure, are rackunit's.
;;
;; Its `fail` is left out: maps of the book have an argument of this name.

(require (for-syntax racket/base)
         (prefix-in rackunit: rackunit)
         (only-in rackunit
                  current-check-handler exn:test:check exn:test:check? fail-check
                  with-check-info))

(provide
 ;; as rackunit has them
 check check-equal? check-eq? check-eqv? check-= check-within check-true check-false
 check-not-equal? check-not-eq? check-not-false check-pred check-exn check-not-exn
 check-regexp-match
 test-case define-check
 with-called        ; (with-called ([name procedure] ...) body ...)
 current-check-handler exn:test:check exn:test:check? fail-check with-check-info)

;; ---------------------------------------------------------------------------
;; Running

(define (run-test name thunk)
  (unless (string? name) (raise-argument-error 'test-case "string?" name))
  (parameterize ([rackunit:current-test-name name]) (rackunit:test-begin (thunk))))

;; place : (location . expression), a location as rackunit has it
(define (run-check place thunk)
  (rackunit:with-default-check-info*
   (list (rackunit:make-check-name (cadr place))
         (rackunit:make-check-location (car place))
         (rackunit:make-check-expression (cdr place)))
   (lambda () ((rackunit:current-check-around) thunk))))

(define (call-with-parameters values message thunk)
  (rackunit:with-default-check-info*
   (cons (rackunit:make-check-params values)
         (if message (list (rackunit:make-check-message message)) '()))
   thunk))

;; ---------------------------------------------------------------------------
;; Expansion

(begin-for-syntax
  ;; file, line, column, position and span
  (define (location stx)
    (define source (syntax-source stx))
    (list (if (path? source) (regexp-replace #rx"^.*/(?=tests/)" (path->string source) "") source)
          (syntax-line stx) (syntax-column stx) (syntax-position stx) (syntax-span stx)))

  ;; procedure : identifier -> transformer of a check
  (define ((check-by procedure) stx)
    (with-syntax ([place (location stx)] [procedure procedure])
      (syntax-case stx ()
        [(name . arguments)
         #`(run-check '(place name . arguments)
                      #,(syntax/loc stx (lambda () (procedure . arguments))))]
        [name
         #'(lambda arguments
             (run-check '(place name) (lambda () (apply procedure arguments))))]))))

(define-syntax (test-case stx)
  (syntax-case stx ()
    [(_ name body ...) #`(run-test name #,(syntax/loc stx (lambda () (void) body ...)))]))

(define-syntax-rule (define-check (name formal ...) body ...)
  (begin
    (define (procedure formal ... [message #f])
      (call-with-parameters (list formal ...) message (lambda () body ... (void))))
    (define-syntax name (check-by #'procedure))))

(define-syntax-rule (define-checks [name original] ...)
  (begin (define-check-by name original) ...))

(define-syntax-rule (define-check-by name original)
  (begin
    (define procedure original)
    (define-syntax name (check-by #'procedure))))

(define-checks
  [check rackunit:check]
  [check-equal? rackunit:check-equal?]
  [check-eq? rackunit:check-eq?]
  [check-eqv? rackunit:check-eqv?]
  [check-= rackunit:check-=]
  [check-within rackunit:check-within]
  [check-true rackunit:check-true]
  [check-false rackunit:check-false]
  [check-not-equal? rackunit:check-not-equal?]
  [check-not-eq? rackunit:check-not-eq?]
  [check-not-false rackunit:check-not-false]
  [check-pred rackunit:check-pred]
  [check-exn rackunit:check-exn]
  [check-not-exn rackunit:check-not-exn]
  [check-regexp-match rackunit:check-regexp-match])

;; ---------------------------------------------------------------------------
;; Checks in a handler or a callback pass if it is never called.

;; The body, in which each of the procedures is called, or it fails.
(define-syntax-rule (with-called ([name procedure] ...) body ...)
  (let ([calls (make-hasheq)])
    (let ([name (noted-in calls 'name procedure)] ...)
      (begin0 (let () body ...)
              (check-called calls 'name) ...))))

(define (noted-in calls name f)
  (procedure-reduce-arity (lambda arguments (hash-set! calls name #t) (apply f arguments))
                          (procedure-arity f)))

(define-check (check-called calls name)
  (unless (hash-ref calls name #f) (fail-check)))

;; ---------------------------------------------------------------------------

(module+ test
  ;; The information of a failed check: (listof (cons name value))
  (define-syntax-rule (told check)
    (with-handlers ([exn:test:check? information])
      (parameterize ([current-check-handler raise]) check)))

  (define (information failure)
    (for/list ([i (in-list (rackunit:exn:test:check-stack failure))])
      (cons (rackunit:check-info-name i) (rackunit:check-info-value i))))

  (define (but-place infos) (filter (lambda (i) (not (memq (car i) '(location expression)))) infos))

  (test-case "a failure tells what rackunit tells of it"
    (define-syntax-rule (same name original argument ...)
      (check-equal? (but-place (told (name argument ...)))
                    (but-place (told (original argument ...)))
                    (format "~a" 'name)))
    (same check-equal? rackunit:check-equal? (+ 1 1) 3)
    (same check-equal? rackunit:check-equal? (+ 1 1) 3 "a sum")
    (same check-= rackunit:check-= 1 2 1/2)
    (same check-true rackunit:check-true (odd? 2) "parity")
    (same check-exn rackunit:check-exn exn:fail? void)
    (same check-regexp-match rackunit:check-regexp-match #rx"b" "a"))

  (test-case "it tells where the check stands, and how it reads"
    (define infos (told (check-eqv? (+ 1 1) 3)))
    (define (shown name) (format "~s" (cdr (assq name infos))))
    (check-regexp-match #rx"[(]check-eqv[?] [(][+] 1 1[)] 3[)]" (shown 'expression))
    (check-regexp-match #rx"tests/mechanics/support/checks.rkt\" [0-9]+ [0-9]+" (shown 'location)))

  (test-case "a check of our own tells its name, what it was given and what it adds"
    (define-check (check-odd n)
      (with-check-info (['rest (remainder n 2)]) (unless (odd? n) (fail-check))))
    (check-odd 3)
    (define infos (told (check-odd 4 "of a pair")))
    (check-equal? (map car infos) '(name location expression params message rest)))

  (test-case "a check without arguments is a function"
    (for-each check-true '(#t #t))
    (check-pred pair? (told (for-each check-true '(#f)))))

  (test-case "the name of a test case is a string"
    (check-exn #rx"^test-case: contract violation\n  expected: string\\?"
               (lambda () (run-test 'a void))))

  (test-case "a procedure that is not called is told by its name"
    (check-equal? (with-called ([f add1] [g sub1]) (g (f 1))) 1)
    (define infos (told (with-called ([f add1] [g sub1]) (f 1))))
    (check-regexp-match #rx" g[)]" (format "~a" (cdr (assq 'params infos))))))
