#lang racket/base
;; Block triangular forms, against the definition of what they are.

(require mechanics/algebra/elimination/block-form
         "../../support/checks.rkt" "../../support/random.rkt")

(define (random-pattern n density)
  (for/vector ([i n])
    (for/list ([j n] #:when (< (random) density)) j)))

(define (entry? entries i j) (and (memv j (vector-ref entries i)) #t))

;; Every way of choosing one entry in each row, in different columns.
(define (transversal? entries)
  (define n (vector-length entries))
  (let loop ([i 0] [taken '()])
    (or (= i n)
        (for/or ([j (in-list (vector-ref entries i))] #:unless (memv j taken))
          (loop (add1 i) (cons j taken))))))

(define (columns-of entries rows)
  (for*/fold ([columns '()]) ([i (in-list rows)] [j (in-list (vector-ref entries i))])
    (if (memv j columns) columns (cons j columns))))

;; Every proper set of k rows has entries in more than k columns.
(define (fully-indecomposable? entries)
  (define n (vector-length entries))
  (for/and ([bits (in-range 1 (sub1 (expt 2 n)))])
    (define rows (for/list ([i n] #:when (bitwise-bit-set? bits i)) i))
    (> (length (columns-of entries rows)) (length rows))))

(define (closure successors)
  (define n (vector-length successors))
  (for/vector ([i n])
    (let loop ([waiting (vector-ref successors i)] [reached '()])
      (cond [(null? waiting) reached]
            [(memv (car waiting) reached) (loop (cdr waiting) reached)]
            [else (loop (append (vector-ref successors (car waiting)) (cdr waiting))
                        (cons (car waiting) reached))]))))

(define (count-up n) (for/list ([i n]) i))
(define (all-rows form) (apply append (map block-rows form)))
(define (all-columns form) (apply append (map block-columns form)))

(test-case "blocks partition rows and columns, and only earlier blocks stand beside one"
  (with-seed 411
    (for* ([n (in-range 1 9)] [density '(0.15 0.3 0.5)] [_ 6])
      (define entries (random-pattern n density))
      (define form (block-triangular-form entries))
      (cond [(deficiency? form)
             (check-false (transversal? entries))
             (define rows (deficiency-rows form))
             (check < (length (columns-of entries rows)) (length rows))]
            [else
             (check-true (transversal? entries))
             (check-equal? (sort (all-rows form) <) (count-up n))
             (check-equal? (sort (all-columns form) <) (count-up n))
             (for/fold ([later (all-columns form)]) ([b (in-list form)])
               (define beyond
                 (for/list ([j (in-list later)] #:unless (memv j (block-columns b))) j))
               (for* ([i (in-list (block-rows b))] [j (in-list beyond)])
                 (check-false (entry? entries i j)))
               beyond)]))))

(test-case "blocks cannot be divided further: whichever row is taken, it needs all others"
  (with-seed 412
    (for* ([n (in-range 2 8)] [_ 10])
      (define entries (random-pattern n 0.4))
      (define form (block-triangular-form entries))
      (unless (deficiency? form)
        (for ([b (in-list form)] #:when (pair? (cdr (block-rows b))))
          ;; rows that touch k < m columns of the block and number k would be a block within it
          (define inside
            (for/vector ([i (in-list (block-rows b))])
              (for/list ([j (in-list (block-columns b))] [l (in-naturals)]
                         #:when (entry? entries i j))
                l)))
          (check-equal? (length (block-triangular-form inside)) 1)
          (check-true (fully-indecomposable? inside)))))))

(test-case "a triangular matrix falls into its diagonal, a permuted one too"
  (check-equal? (block-triangular-form #((0) (0 1) (0 1 2)))
                (list (block '(0) '(0)) (block '(1) '(1)) (block '(2) '(2))))
  (check-equal? (block-triangular-form #((0 1 2) (1 2) (2)))
                (list (block '(2) '(2)) (block '(1) '(1)) (block '(0) '(0))))
  (check-equal? (block-triangular-form #((1) (0 2) (0 1 2)))
                (list (block '(0) '(1)) (block '(1 2) '(0 2)))))

(test-case "rows without enough columns are named"
  (check-equal? (block-triangular-form #((1) (0 1 2) (1))) (deficiency '(0 2)))
  (check-equal? (block-triangular-form #(())) (deficiency '(0))))

(test-case "strong components: who reaches whom and back"
  (with-seed 413
    (for* ([n (in-range 1 8)] [_ 10])
      (define successors (random-pattern n 0.25))
      (define reach (closure successors))
      (define components (strong-components successors))
      (check-equal? (sort (apply append components) <) (count-up n))
      (for* ([c (in-list components)] [i (in-list c)] [j n])
        (define both-ways? (and (memv j (vector-ref reach i)) (memv i (vector-ref reach j)) #t))
        (check-equal? (and (memv j c) #t) (or (= i j) both-ways?)))
      ;; successors first
      (for/fold ([before '()]) ([c (in-list components)])
        (define known (append c before))
        (for* ([i (in-list c)] [j (in-list (vector-ref successors i))])
          (check-not-false (memv j known)))
        known))))

(test-case "the sign of a permutation"
  (check-equal? (permutation-sign '()) 1)
  (check-equal? (permutation-sign '(0 1 2)) 1)
  (check-equal? (permutation-sign '(1 0 2)) -1)
  (check-equal? (permutation-sign '(1 2 0)) 1)
  (check-equal? (permutation-sign '(7 5 3)) -1))
